// SPDX-License-Identifier: BSD-3-Clause
#include "style.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

namespace tool {
namespace {

std::string dressed(std::string_view text, const char* code, bool colors) {
    return colors ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
}

} // namespace

bool colors_wanted(int descriptor, bool allowed) {
    const char* no_color = std::getenv("NO_COLOR");
    const char* terminal = std::getenv("TERM");
    const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
    const bool refused = !allowed || (no_color != nullptr && *no_color != '\0');
    return !refused && !dumb && ::isatty(descriptor) != 0;
}

std::string bold(std::string_view text, bool colors) {
    return dressed(text, "1", colors);
}

std::string dim(std::string_view text, bool colors) {
    return dressed(text, "2", colors);
}

void print_message(std::string_view text, Tone tone, bool colors_allowed) {
    const bool colors = colors_wanted(STDERR_FILENO, colors_allowed);
    const char* color = tone == Tone::error ? "31" : "33";
    const std::string line = dressed("stltsa:", color, colors) + fmt::format(" {}\n", text);
    std::fputs(line.c_str(), stderr);
}

} // namespace tool
