// SPDX-License-Identifier: BSD-3-Clause
// Numbers that stand for a missing value, such as -9999.
#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Makes them NaN, and says which and how many. Their digits are nines (999, -9999, 9999000), or they
/// are the largest of their precision; they are in three cells or more outside the other numbers of
/// the column, and in one column farther than these are apart.
void drop_missing_codes(Matrix& values, const std::vector<std::string>& names, PacedPoll& polls,
                        std::vector<std::string>& notes);

} // namespace stltsa::clip
