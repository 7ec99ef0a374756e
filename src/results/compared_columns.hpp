// SPDX-License-Identifier: BSD-3-Clause
// The joints, points or columns that two clips have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "results/phased.hpp"

namespace stltsa::results {

/// What two motions are compared in: column i of the comparison is first[i] and second[i] of the
/// features.
struct CommonColumns {
    std::vector<std::int64_t> first, second;
    std::vector<std::int64_t> part; ///< index of the joint, point or column of the file
    std::vector<std::string> axis;  ///< "x" or "rz"; empty: a part has one column
    std::vector<std::string> names, other_names;       ///< of each part
    std::vector<std::string> left_out, other_left_out; ///< those that the other clip lacks
};

/// By name; names that recur by their order. Axes are those of the first clip: if the second has
/// another up axis, its axes are exchanged. Throws Status::shape if the features differ, or nothing
/// is common.
CommonColumns common_columns(const Phased& first, const Phased& second);

/// Left and right of one clip, whose names differ only in the side: both columns are the left one,
/// as of a mirror image. Throws Status::unsupported if there are none.
CommonColumns side_columns_of(const Phased& phased);

/// Whether columns are coordinates in space, three for each part.
bool in_space(const Phased& phased);

} // namespace stltsa::results
