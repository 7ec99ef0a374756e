// SPDX-License-Identifier: BSD-3-Clause
#include "base/json.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace stltsa {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD
constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1); // npos + 1 is 0
}

/// The place of the quote that ends the string which begins at `begin`; the size if there is none.
std::size_t string_end(std::string_view text, std::size_t begin) {
    std::size_t at = begin + 1;
    while (at < text.size() && text[at] != '"')
        at += text[at] == '\\' ? 2 : 1;
    return std::min(at, text.size());
}

} // namespace

Json::Json(std::int64_t value) : text_(format_text("{}", value)) {}

Json::Json(double value) : text_(std::isfinite(value) ? format_text("{}", value) : "null") {}

Json::Json(std::string_view text) : text_("\"") {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text, at);
        const std::string_view character = text.substr(at, length);
        if (length == 0)
            text_ += replacement;
        else if (is_control(character)) // its last byte is its number
            text_ += format_text("\\u{:04x}", static_cast<unsigned char>(character.back()));
        else if (character == "\"" || character == "\\")
            text_ += "\\" + std::string(character);
        else
            text_ += character;
        at += length == 0 ? 1 : length;
    }
    text_ += '"';
}

std::vector<std::string_view> json_parts(std::string_view text) {
    std::vector<std::string_view> parts;
    std::int64_t depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"')
            i = string_end(text, i);
        else if (c == '{' || c == '[')
            begin = ++depth == 1 ? i + 1 : begin;
        else if (c == ',' ? depth == 1 : (c == '}' || c == ']') && --depth == 0) {
            if (const auto part = trimmed(text.substr(begin, i - begin)); !part.empty())
                parts.push_back(part);
            begin = i + 1;
        }
    }
    return parts;
}

std::string_view json_member(std::string_view object, std::string_view name) {
    const std::string key = Json(name).text();
    for (std::string_view part : json_parts(object))
        if (part.starts_with(key)) {
            part = trimmed(part.substr(key.size()));
            return trimmed(part.substr(std::min<std::size_t>(1, part.size()))); // after the colon
        }
    return {};
}

std::string json_string(std::string_view value) {
    std::string text;
    for (std::size_t i = 1; value.starts_with('"') && i + 1 < value.size(); ++i)
        if (value[i] != '\\') {
            text += value[i];
        } else if (value[++i] == 'u' && i + 5 < value.size()) {
            unsigned code = 0;
            std::from_chars(value.data() + i + 1, value.data() + i + 5, code, 16);
            text += code < 0x80 ? "" : "\xC2"; // Json writes none above U+009F so
            text += static_cast<char>(code);
            i += 4;
        } else {
            text += value[i];
        }
    return text;
}

} // namespace stltsa
