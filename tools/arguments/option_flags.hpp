// SPDX-License-Identifier: BSD-3-Clause
// The library's options as flags: names, texts, ranges and choices come from its options table.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <stltsa.hpp>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace tool {

/// Adds the flag of an option to a command, with this text; what is typed goes into `typed`.
/// Returns the flag.
CLI::Option* add_option_flag(CLI::App& app, const stltsa::OptionInfo& info, const std::string& text,
                             std::map<std::int32_t, std::string>& typed);

/// Sets what was typed. Lengths in seconds (1.2s) need the rate of the frames that they count,
/// so they are left for set_lengths(). Throws Failure with Exit::usage.
void set_options(stltsa::Options& options, const std::map<std::int32_t, std::string>& typed);

/// Sets the lengths typed in seconds; rate 0: unknown, which is an error if there is any.
void set_lengths(stltsa::Options& options, const std::map<std::int32_t, std::string>& typed,
                 double rate);

/// What the user types: "--period-min".
std::string flag_of(std::int32_t key);

/// The library's "option period_min" in a text as the user knows it: "--period-min"; also "the
/// option" and the second of "option a or b".
std::string with_flags(std::string text);

} // namespace tool
