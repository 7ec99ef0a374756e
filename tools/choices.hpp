// SPDX-License-Identifier: BSD-3-Clause
// Values that have names in the library's tables: "temporal=1 spatial=2".
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <stltsa.hpp>

namespace tool {

using Choices = std::vector<std::pair<std::string, std::int64_t>>;
Choices choices_in(const std::string& text);

/// "preparing", "initial" and so on: the kinds of units, without "cycle".
std::vector<std::string> unit_names();

/// What a fact of that kind says: "temporal".
std::string named(const stltsa::Info& info, std::int32_t key);

} // namespace tool
