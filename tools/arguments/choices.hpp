// SPDX-License-Identifier: BSD-3-Clause
// Named values from the library's tables: "temporal=1 spatial=2".
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <stltsa.hpp>

namespace tool {

using Choices = std::vector<std::pair<std::string, std::int64_t>>;
Choices choices_in(const std::string& text);

/// The kinds of units, without "cycle": "preparing", "initial" and so on.
std::vector<std::string> unit_names();

/// The name of a fact's value: "temporal".
std::string named(const stltsa::Info& info, std::int32_t key);

} // namespace tool
