// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes numbers, independent of the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stltsa::clip {

/// The whole of `text` as a number; a leading '+' is allowed. May be infinite or NaN ("nan", "inf",
/// 1e999); values too small for a double are 0. Empty if it is not a number.
std::optional<double> parse_number(std::string_view text);

/// Appends the shortest digits that read back to the same bits.
void append_number(std::string& text, double value);
/// Its work compared with adding; for checkpoint().
inline constexpr std::int64_t work_of_number = 32;

std::optional<std::int64_t> parse_integer(std::string_view text);

/// Frames per second from the seconds of one frame; 0 if these are 0 or too small. Rounds to a
/// nearby integer, because frame times are written with few digits: .0083333 -> 120.
double rate_of(double seconds);

} // namespace stltsa::clip
