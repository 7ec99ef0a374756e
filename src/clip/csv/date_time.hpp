// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

namespace stltsa::clip {

constexpr double seconds_a_day = 86400;

/// Seconds since 1970 (UTC, unless the cell names no zone) of a date such as 2024-01-31,
/// 2024-01-31 12:00:00.033 or 2024-01-31T12:00:00+01:00; seconds since midnight of a time of day
/// such as 12:00:00.033. Empty if the cell is neither.
std::optional<double> parse_date_time(std::string_view cell);

} // namespace stltsa::clip
