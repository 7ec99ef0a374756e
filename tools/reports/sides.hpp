// SPDX-License-Identifier: BSD-3-Clause
// Compares left with right for each motion that has cycles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <stltsa.hpp>

#include "reports/json.hpp"

namespace tool {

struct LabelSides {
    std::string letters;                          ///< the label
    std::optional<stltsa::Comparison> comparison; ///< empty: see `reason`
    std::string reason;
};

Json sides_json(const std::vector<LabelSides>& all);
std::string sides_report(const std::vector<LabelSides>& all);

} // namespace tool
