// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace stltsa {

/// Bytes of the well-formed UTF-8 sequence at `at` (RFC 3629, section 4); 0 if there is none.
std::size_t utf8_length(std::string_view text, std::size_t at);

/// Whether a character is a control character of ASCII or of Latin-1 (U+0080 to U+009F).
bool is_control(std::string_view character);

} // namespace stltsa
