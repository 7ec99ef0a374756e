// SPDX-License-Identifier: BSD-3-Clause
// Numbers that stand for a missing value, such as -9999.
#pragma once

#include <string>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Makes them NaN, and says which and how many. Such numbers are of nines (999, -9999, 9999000),
/// powers of ten from a million, or the largest of their precision. They are in three cells or more
/// outside the other numbers of the column, and in one column farther than these are apart, or in
/// two alone.
void drop_missing_codes(Matrix& values, const std::vector<std::string>& names,
                        std::vector<std::string>& notes);

} // namespace stltsa::clip
