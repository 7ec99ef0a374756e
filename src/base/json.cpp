// SPDX-License-Identifier: BSD-3-Clause
#include "base/json.hpp"

#include <cmath>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace stltsa {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

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

} // namespace stltsa
