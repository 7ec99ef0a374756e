// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/checkpoint.hpp"

namespace tool {

/// After this call the first Ctrl-C is recorded and the second ends the process. If the caller
/// ignores SIGINT (background jobs of scripts), it stays ignored.
void watch_interrupt();

bool interrupted();

/// Throws Failure "cancelled" after a Ctrl-C.
void stop_if_interrupted();

/// During its lifetime the command's waits for files and pipes end after a Ctrl-C.
class Interruptible final : public stltsa::Checkpoints {
  public:
    Interruptible() : Checkpoints(true) {}
    void check() override { stop_if_interrupted(); }
};

} // namespace tool
