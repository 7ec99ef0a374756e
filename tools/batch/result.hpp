// SPDX-License-Identifier: BSD-3-Clause
// The file of a result: the JSON of `stltsa decompose --json`, and what it was made from.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace tool::batch {

/// What a result depends on, and its `source`: where its clip is, from the folder of results.
using Origin = nlohmann::ordered_json;

/// The path of a file from the folder of results, so that both may be moved together.
std::string source_of(const std::string& file, const std::string& out);

/// The text of the file. Its last member, "batch", has the origin and a CRC-32 of all before it.
std::string with_origin(const std::string& result, const Origin& origin);

/// The result of an earlier run, if it is undamaged and was made from the same. Throws Failure if
/// it is the result of another clip, which is still there.
std::optional<nlohmann::json> kept_result(const std::string& place, const Origin& origin);

} // namespace tool::batch
