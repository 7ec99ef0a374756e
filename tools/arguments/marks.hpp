// SPDX-License-Identifier: BSD-3-Clause
// Moments with names: "131=strike", "2.5s=strike".
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tool {

/// Frames by name.
using Marks = std::map<std::string, std::vector<double>>;

/// Throws Failure with Exit::usage for a wrong one. `fps` 0: unknown.
Marks parse_marks(const std::vector<std::string>& given, double fps);

} // namespace tool
