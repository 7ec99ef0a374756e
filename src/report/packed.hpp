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

/// {"rows", "cols", "low", "unit", "data"}. A value in column c is low[c % n] + unit[c % n] *
/// integer with n = `ranges`; the integer 65535 is NaN. The integers go column by column, each as
/// the difference, modulo 65536, from the one above it: first all low bytes, then all high bytes,
/// compressed by zlib, in base64.
Json packed(ConstMatrixView values, std::int64_t ranges);
/// Each column has a range of its own.
Json packed(ConstMatrixView values);
/// A single column.
Json packed(std::span<const double> values);

/// Text compressed by zlib, in base64.
std::string compressed_text(const std::string& text);

} // namespace stltsa::report
