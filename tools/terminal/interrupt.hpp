// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tool {

/// After this call the first Ctrl-C is recorded and the second ends the process. If the caller
/// ignores SIGINT (background jobs of scripts), it stays ignored.
void watch_interrupt();

bool interrupted();

/// Throws Failure "cancelled" after a Ctrl-C.
void stop_if_interrupted();

} // namespace tool
