// SPDX-License-Identifier: BSD-3-Clause
// Numbers as files write them, the same in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stltsa::clip {

/// The whole of `text` as a number, a leading '+' allowed. May be infinite or NaN ("nan", "inf",
/// 1e999); what is too small for a double is 0. Nothing when it is no number.
std::optional<double> parse_number(std::string_view text);

/// Adds the shortest digits that read back to the same bits.
void append_number(std::string& text, double value);

std::optional<std::int64_t> parse_integer(std::string_view text);

/// Frames a second from the seconds of one; 0 where these are 0 (or as good as). Frame times are
/// written with a few digits and mean the integral rate: .0083333 -> 120.
double rate_of(double seconds);

} // namespace stltsa::clip
