// SPDX-License-Identifier: BSD-3-Clause
// The report of a comparison: one HTML page that needs nothing else.
#pragma once

#include <string>

#include "results/compared.hpp"

namespace stltsa::report {

/// `json`: of the comparison; `command`: which repeats it; empty: unknown.
std::string comparison_page(const results::Comparison& comparison, const std::string& json,
                            const std::string& command);

} // namespace stltsa::report
