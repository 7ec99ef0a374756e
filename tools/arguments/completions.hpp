// SPDX-License-Identifier: BSD-3-Clause
// Completions for shells, made from the parser, so that they know what it knows.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace tool {

/// "-h", "--help"
std::vector<std::string> dashed_names(const CLI::Option& option);

/// The script for "bash", "zsh" or "fish". Throws Failure with Exit::usage for another shell.
std::string completions(const CLI::App& app, const std::string& shell);

} // namespace tool
