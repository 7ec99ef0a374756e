// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/interrupt.hpp"

#include <csignal>

#include "exit_status.hpp"

namespace tool {
namespace {

volatile std::sig_atomic_t seen = 0;

extern "C" void note_interrupt(int) {
    seen = 1;
}

} // namespace

void watch_interrupt() {
    struct sigaction before {};
    sigaction(SIGINT, nullptr, &before);
    if (before.sa_handler == SIG_IGN)
        return;
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND); // no SA_RESTART: also ends a blocked read
    sigaction(SIGINT, &action, nullptr);
}

bool interrupted() {
    return seen != 0;
}

void stop_if_interrupted() {
    if (interrupted())
        throw Failure(Exit::interrupted, "cancelled");
}

} // namespace tool
