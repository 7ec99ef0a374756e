// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json_value.hpp"

#include <cmath>

#include "base/text.hpp"

namespace stltsa::capi {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

unsigned byte_at(std::string_view text, std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u;
}

/// Bytes of the well-formed UTF-8 sequence at `at` (RFC 3629, section 4); 0: there is none.
std::size_t sequence_length(std::string_view text, std::size_t at) {
    const unsigned first = byte_at(text, at);
    if (first < 0x80)
        return 1;
    const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    // No overlong forms, no surrogates, nothing beyond U+10FFFF.
    const unsigned low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const unsigned high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    for (std::size_t i = 1; i < length; ++i) {
        const unsigned next = byte_at(text, at + i);
        if (next < (i == 1 ? low : 0x80) || next > (i == 1 ? high : 0xBF))
            return 0;
    }
    return length;
}

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
        const std::size_t length = sequence_length(text, at);
        if (length == 1)
            append_escaped(text_, text[at]);
        else
            text_ += length == 0 ? replacement : text.substr(at, length);
        at += length == 0 ? 1 : length;
    }
    text_ += '"';
}

} // namespace stltsa::capi
