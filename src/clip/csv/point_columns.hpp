// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clip/clip.hpp"
#include "clip/features/subject_names.hpp"

namespace stltsa::clip {

/// If the columns are the coordinates of points, in any order, with or without their confidence,
/// the clip becomes one of points of one subject: columns of confidence go, and points that are
/// seen with less than the option says are missing. If there are enough points beside triples of
/// other quantities, such as angles and forces, or beside fewer other columns, these are left out.
/// Notes say what is left out, and why columns that are named as points are not taken. `file` is
/// its path; a name such as "walk_rot.csv" says that its columns are angles.
/// `stated`: the subjects that the header states.
void take_points(Clip& clip, const std::string& file, const ReadOptions& options,
                 const std::vector<Subject>& stated = {});

/// Keeps the columns of one subject, which are not those of points.
void take_columns_of_subject(Clip& clip, const std::string& file, const ReadOptions& options,
                             const std::vector<Subject>& stated = {});

/// Keeps these columns only, in this order.
void keep_columns(Clip& clip, const std::vector<std::int64_t>& columns);

} // namespace stltsa::clip
