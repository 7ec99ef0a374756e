// SPDX-License-Identifier: BSD-3-Clause
// The moving body of a report: joints, points or, for a matrix, its columns.
#pragma once

#include <string>
#include <vector>

#include "base/json.hpp"
#include "clip/clip.hpp"
#include "clip/features/prepare.hpp"

namespace stltsa::report {

/// A joint, a point or a column.
struct Part {
    std::string name;
    int side = -1;             ///< 0: left, 1: right, -1: neither
    std::int64_t partner = -1; ///< index of the same part on the other side; -1: none
};

/// The parts of a clip.
std::vector<Part> parts_of(const clip::Clip& clip);

/// How many numbers a posture has: coordinates of joints or points, or columns.
std::int64_t places_width(const clip::Clip& clip);

/// What moves, and where it is in every step-th frame: as many frames as the text has room for.
Json body_json(const clip::Clip& clip, const std::vector<Part>& parts, clip::Axis up,
               std::int64_t longest_text);

} // namespace stltsa::report
