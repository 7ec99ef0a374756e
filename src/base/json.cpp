// SPDX-License-Identifier: BSD-3-Clause
#include "base/json.hpp"

#include <cmath>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace stltsa {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

/// Appends a character of ASCII.
void append_escaped(std::string& to, char c) {
    if (c == '"' || c == '\\') {
        to += '\\';
        to += c;
    } else if (c < 0x20 || c == 0x7F) {
        to += format_text("\\u{:04x}", static_cast<unsigned>(c));
    } else {
        to += c;
    }
}

/// U+0080 to U+009F: control characters of terminals, as those of ASCII are.
bool is_control(std::string_view character) {
    return character.size() == 2 && character[0] == '\xC2' &&
           static_cast<unsigned char>(character[1]) < 0xA0;
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
        else if (length == 1)
            append_escaped(text_, text[at]);
        else if (is_control(character))
            text_ += format_text("\\u00{:02x}", static_cast<unsigned char>(character[1]));
        else
            text_ += character;
        at += length == 0 ? 1 : length;
    }
    text_ += '"';
}

} // namespace stltsa
