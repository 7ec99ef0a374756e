// SPDX-License-Identifier: BSD-3-Clause
// What differs between the cycles of two motions.
#pragma once

#include <string>

#include <stltsa.hpp>

namespace tool {

/// `first`, `second`: what the clips are called.
std::string comparison_report(const stltsa::Comparison& comparison, const std::string& first,
                              const std::string& second);

/// A row for each part and each of its channels.
std::string comparison_csv(const stltsa::Comparison& comparison);

} // namespace tool
