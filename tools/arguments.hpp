// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace tool {

enum class Command { info, fit, dimension, decompose };

/// The command line, read.
struct Arguments {
    Command command = Command::info;
    std::string input;                           ///< "-": standard input
    std::map<std::int32_t, std::string> options; ///< by STLTSA_* key, as typed
    std::string output;                          ///< empty: standard output
    std::string plot;
    std::string coords;
    bool json = false;
    bool curve = false; ///< in the JSON
    bool quiet = false;
    bool no_color = false;

    std::string answer; ///< not empty: a --help or --version to print instead
};

/// Throws Failure with Exit::usage for a wrong command line.
Arguments parse_arguments(int argc, const char* const* argv);

} // namespace tool
