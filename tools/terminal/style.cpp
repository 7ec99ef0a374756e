// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/style.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

#include "base/utf8.hpp"

namespace tool {
namespace {

// A file name with these bytes merely changes the style.
constexpr char bold_mark = '\x01';
constexpr char dim_mark = '\x02';
constexpr char end_mark = '\x03';

std::string marked(char mark, std::string_view text) {
    return mark + std::string(text) + end_mark;
}

std::string_view code_of(char mark) {
    return mark == bold_mark ? "\x1b[1m" : mark == dim_mark ? "\x1b[2m" : "\x1b[0m";
}

/// Whether a character turns the direction of the text after it (U+202A to U+202E, U+2066 to
/// U+2069).
bool turns_direction(std::string_view character) {
    return (character >= "\xE2\x80\xAA" && character <= "\xE2\x80\xAE") ||
           (character >= "\xE2\x81\xA6" && character <= "\xE2\x81\xA9");
}

/// Whether a character may control the terminal.
bool is_dangerous(std::string_view character) {
    const bool is_blank = character == "\n" || character == "\t";
    return (stltsa::is_control(character) && !is_blank) || turns_direction(character);
}

} // namespace

bool colors_wanted(int descriptor, bool allowed) {
    const char* no_color = std::getenv("NO_COLOR");
    const bool refused = !allowed || (no_color != nullptr && *no_color != '\0');
    return !refused && obeys_codes(descriptor);
}

bool obeys_codes(int descriptor) {
    const char* terminal = std::getenv("TERM");
    const std::string_view kind = terminal == nullptr ? "" : terminal;
    const bool dumb = kind.empty() || kind == "dumb";
    return !dumb && ::isatty(descriptor) != 0;
}

std::string bold(std::string_view text) {
    return marked(bold_mark, text);
}

std::string dim(std::string_view text) {
    return marked(dim_mark, text);
}

std::string shown(std::string_view text, bool colors) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = stltsa::utf8_length(text, 0);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
        const char first = character[0];
        if (first == bold_mark || first == dim_mark || first == end_mark)
            result += colors ? code_of(first) : "";
        else if (length == 0 || is_dangerous(character))
            result += '?';
        else
            result += character;
        text.remove_prefix(character.size());
    }
    return result;
}

void print_message(std::string_view text, Tone tone, bool colors_allowed) {
    const bool colors = colors_wanted(STDERR_FILENO, colors_allowed);
    const char* color = tone == Tone::error ? "\x1b[31m" : "\x1b[33m";
    const std::string line = fmt::format("{}stltsa:{} {}\n", colors ? color : "",
                                         colors ? "\x1b[0m" : "", shown(text, false));
    std::fputs(line.c_str(), stderr);
}

} // namespace tool
