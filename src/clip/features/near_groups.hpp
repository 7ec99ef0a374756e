// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Divides groups of `width` columns into sets of at most `most` that are near each other, each in
/// ascending order: points by their mean place, columns by their number, since neighbors in a table
/// belong together. Takes a time that is linear in the groups, but for a logarithm.
std::vector<std::vector<std::int64_t>> near_groups(const Matrix& rows, int width,
                                                   const std::vector<std::int64_t>& groups,
                                                   std::int64_t most);

} // namespace stltsa::clip
