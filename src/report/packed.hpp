// SPDX-License-Identifier: BSD-3-Clause
// Numbers for the page of a report: 16-bit integers, compressed, as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/json.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::report {

/// CRC-32 of the bytes, as 8 hexadecimal digits.
std::string checksum(std::string_view bytes);

/// {"rows", "cols", "low", "unit", "data"}. A value is low[c % n] + unit[c % n] * integer, where
/// column c has the range c % n of n = `ranges`; 65535 is NaN. The integers stand column by column,
/// each as the difference from the one above it modulo 65536: first all low bytes, then all high
/// bytes, compressed by zlib, in base64.
Json packed(ConstMatrixView values, std::int64_t ranges);
/// With a range for each column.
Json packed(ConstMatrixView values);
/// A column.
Json packed(std::span<const double> values);

/// Text compressed by zlib, in base64.
std::string compressed_text(const std::string& text);

} // namespace stltsa::report
