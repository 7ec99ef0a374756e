// SPDX-License-Identifier: BSD-3-Clause
// Formats text with {fmt}. Its code is compiled once, in text.cpp: instantiated in every file with
// a message, it would take most of the build time.
#pragma once

#include <string>

#include <fmt/core.h>

namespace stltsa {

std::string format_arguments(fmt::string_view text, fmt::format_args arguments);

/// fmt::format; the format is checked at compile time.
template <class... Args>
std::string format_text(fmt::format_string<Args...> text, Args&&... args) {
    return format_arguments(text, fmt::make_format_args(args...));
}

} // namespace stltsa
