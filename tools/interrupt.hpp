// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tool {

/// From here on the first Ctrl-C is noted and the second one ends the process, as ever. Where the
/// caller ignores SIGINT (background jobs of scripts), it stays ignored.
void watch_interrupt();

bool interrupted();

/// Throws Failure "cancelled" after a Ctrl-C.
void stop_if_interrupted();

} // namespace tool
