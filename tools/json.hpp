// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace tool {

using Json = nlohmann::ordered_json;

/// Compiled once: in every file that asks for an object it would be half of what that takes.
Json parsed_json(const std::string& text);

} // namespace tool
