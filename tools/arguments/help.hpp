// SPDX-License-Identifier: BSD-3-Clause
// What --help says.
#pragma once

#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "arguments/arguments.hpp"

namespace tool {

/// Groups of options, in this order.
namespace group {
constexpr const char* output = "Output";
constexpr const char* input = "Input";
constexpr const char* method = "Method";
constexpr const char* messages = "Messages";
} // namespace group

/// The program's description, with examples, and what stands below the list of commands.
extern const char* const about;
extern const char* const ending;

/// A command's description: a line, and examples.
std::string about_command(Command command);

/// Texts wrapped to the terminal's width, options in groups, and one line for each command.
std::shared_ptr<CLI::FormatterBase> help_format();

} // namespace tool
