// SPDX-License-Identifier: BSD-3-Clause
// The command stltsa: motion clips to units and cycles, through the public API of libstltsa.
#include <csignal>
#include <cstdio>

#include "commands/commands.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/style.hpp"

namespace {

using namespace tool;

Exit run(const Arguments& arguments) {
    switch (arguments.command) {
    case Command::batch:
        return run_batch(arguments);
    case Command::compare:
        return run_compare(arguments);
    case Command::events:
        return run_events(arguments);
    case Command::info:
        return run_info(arguments);
    case Command::fit:
        return run_fit(arguments);
    case Command::live:
        return run_live(arguments);
    case Command::map:
        return run_map(arguments);
    case Command::unmap:
        return run_unmap(arguments);
    case Command::dimension:
        return run_dimension(arguments);
    case Command::decompose:
        return run_decompose(arguments);
    case Command::denoise:
        return run_denoise(arguments);
    case Command::synthesize:
        return run_synthesize(arguments);
    }
    return Exit::usage;
}

int ended_by(const Failure& failure, bool colors) {
    print_message(failure.what(), Tone::error, colors);
    return static_cast<int>(failure.status());
}

} // namespace

int main(int argc, char** argv) {
    bool colors = true;
    try {
        watch_interrupt();
        const Interruptible waits;
        std::signal(SIGPIPE, SIG_IGN); // a closed pipe is a failed write, with its message
        const Arguments arguments = parse_arguments(argc, argv);
        colors = !arguments.no_color;
        if (arguments.answer.empty())
            return static_cast<int>(run(arguments));
        write_stdout(arguments.answer);
        return static_cast<int>(Exit::done);
    } catch (const Failure& failure) {
        return ended_by(failure, colors);
    } catch (const stltsa::Error& error) {
        return ended_by(Failure(error), colors);
    } catch (const std::exception& error) {
        print_message(error.what(), Tone::error, colors);
        return static_cast<int>(Exit::failed);
    }
}
