// SPDX-License-Identifier: BSD-3-Clause
// The joints, points or columns that two clips have in common.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "results/phased.hpp"

namespace stltsa::results {

/// Columns that are compared: column i is column first[i] of the first clip's features and column
/// second[i] of the second's.
struct CommonColumns {
    std::vector<std::int64_t> first, second;
    std::vector<std::int64_t> part; ///< index of the joint, point or column of the file
    std::vector<std::string> axis;  ///< such as "x" or "rz"; empty: the only column of its part
    std::vector<std::string> names, other_names;       ///< of each part
    std::vector<std::string> left_out, other_left_out; ///< names that the other clip lacks
};

/// Matches parts by name, and parts with the same name by their order. Axes are those of the first
/// clip: if the second has a different up axis, its axes are rotated. Throws Status::shape if the
/// clips have different features or no name in common.
CommonColumns common_columns(const Phased& first, const Phased& second);

/// Left and right of one clip, whose names differ only in the side: both columns are the left one,
/// because the second motion is the mirror image. Throws Status::unsupported if there are none.
CommonColumns side_columns_of(const Phased& phased);

/// The same of signals such as knee_l and knee_r, one name for each column.
CommonColumns side_columns_of(std::span<const std::string> names);

/// Whether columns are coordinates in space, three for each part.
bool in_space(const Phased& phased);

} // namespace stltsa::results
