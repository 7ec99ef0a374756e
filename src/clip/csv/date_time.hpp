// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

namespace stltsa::clip {

/// Seconds since 1970 of a date and a time as in ISO 8601, "2024-01-31 12:00:00.033" or
/// "2024-01-31T12:00:00Z"; of a time alone, "12:00:00.033", seconds since midnight. Empty: it is
/// none.
std::optional<double> parse_date_time(std::string_view cell);

} // namespace stltsa::clip
