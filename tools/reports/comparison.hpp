// SPDX-License-Identifier: BSD-3-Clause
// The differences between the cycles of two motions, as text and as CSV.
#pragma once

#include <string>

#include <stltsa.hpp>

namespace tool {

/// `first`, `second`: names of the clips.
std::string comparison_report(const stltsa::Comparison& comparison, const std::string& first,
                              const std::string& second);

/// A row for each part, followed by a row for each of its channels.
std::string comparison_csv(const stltsa::Comparison& comparison);

} // namespace tool
