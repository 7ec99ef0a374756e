// SPDX-License-Identifier: BSD-3-Clause
// The file of a result: the JSON of stltsa_decomposition_json(), what it was made from, and its row
// in the summary.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "capi/options/reader.hpp"
#include "stltsa.h"

namespace stltsa::capi::batch {

/// What a result depends on. Each text is JSON.
struct Origin {
    std::string source; ///< the clip's path from the folder of results: both may move together
    std::string rest;   ///< the other members: size, checksum, options and library
};
Origin origin_of(const std::string& clip, const std::string& folder, const stltsa_options& options);

/// The text of the file. Its last member, "batch", has the origin and a CRC-32 of all before it.
std::string with_origin(const std::string& result, const Origin& origin);

/// The text of an earlier run, if it is undamaged and was made from the same. Throws Status::io if
/// it is the result of another clip, which is still there, or if no result can be written there.
std::optional<std::string> kept_result(const std::string& place, const Origin& origin);

/// Every summary begins so.
inline constexpr std::string_view summary_begin = "path,status,error,";
/// The names of the columns.
inline constexpr std::string_view summary_head =
    "path,status,error,frames,segments,cycles,repetitions,period_s,fps,duration_s,confidence,"
    "reason\n";
static_assert(summary_head.starts_with(summary_begin));

/// The row of a clip whose result is this JSON.
std::string row_of(const std::string& path, std::string_view result);

std::string failed_row(const std::string& path, stltsa_status status, const std::string& error);

} // namespace stltsa::capi::batch
