// SPDX-License-Identifier: BSD-3-Clause
#include "report/comparison_page.hpp"

#include "base/json.hpp"
#include "report/packed.hpp"
#include "report/template.hpp"

namespace stltsa::report {

std::string comparison_page(const results::Comparison& comparison, const std::string& json,
                            const std::string& command) {
    const results::Placement& placed = comparison.placement;
    JsonObject data("format", "stltsa-comparison-report/1", "command", command, "up",
                    static_cast<int>(placed.up) - 1, "skeleton", placed.skeleton);
    if (placed.in_space)
        data.set("parents", placed.parents);
    data.set("comparison", compressed_text(json));
    return filled(comparison_template(), data.text());
}

} // namespace stltsa::report
