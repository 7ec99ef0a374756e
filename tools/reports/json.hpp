// SPDX-License-Identifier: BSD-3-Clause
// JSON that the command adds to the library's.
#pragma once

#include <string>

#include <stltsa.hpp>

#include "base/json.hpp"

namespace tool {

using Json = stltsa::Json;
using JsonObject = stltsa::JsonObject;

/// null for "", the path of data read from memory.
Json json_or_null(const std::string& text);
/// null for 0, an unknown rate.
Json json_or_null(double value);
Json json_rows(const stltsa::Matrix& table);
/// The frames of the working samples.
Json json_frames(const stltsa::Info& samples);

/// The object with one more member.
std::string with_member(std::string object, const char* name, const Json& value);

} // namespace tool
