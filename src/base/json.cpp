// SPDX-License-Identifier: BSD-3-Clause
#include "base/json.hpp"

#include <cmath>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace stltsa {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

void append_escaped(std::string& to, char c) {
    if (c == '"' || c == '\\') {
        to += '\\';
        to += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
        to += format_text("\\u{:04x}", static_cast<unsigned>(c));
    } else {
        to += c;
    }
}

} // namespace

Json::Json(std::int64_t value) : text_(format_text("{}", value)) {}

Json::Json(double value) : text_(std::isfinite(value) ? format_text("{}", value) : "null") {}

Json::Json(std::string_view text) : text_("\"") {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text, at);
        if (length == 1)
            append_escaped(text_, text[at]);
        else
            text_ += length == 0 ? replacement : text.substr(at, length);
        at += length == 0 ? 1 : length;
    }
    text_ += '"';
}

} // namespace stltsa
