// SPDX-License-Identifier: BSD-3-Clause
// Completions for shells, made from the parser, so that they know what it knows.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace tool {

/// The script for "bash", "zsh" or "fish". Throws Failure with Exit::usage for another shell.
std::string completions(const CLI::App& app, const std::string& shell);

} // namespace tool
