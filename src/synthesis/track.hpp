// SPDX-License-Identifier: BSD-3-Clause
// A clip as the joins see it: what a posture is, how alike two are, where the body stands.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synthesis/root.hpp"

namespace stltsa::synthesis {

struct Track {
    std::string name;    ///< of the clip, for messages
    SharedMatrix values; ///< channels, at the frame rate of the new clip
    double fps = 0;
    std::int64_t first = 0; ///< frames at the start that are a T-pose snapping into the motion
    std::vector<RootState> roots;
    /// Joints relative to the body root, as seen along its heading, and their velocities per
    /// second. One row more than there are frames: how the motion would go on.
    Matrix postures;
    Matrix velocities;

    std::int64_t frames() const { return values.rows(); }
    const RootState& root(std::int64_t frame) const {
        return roots[static_cast<std::size_t>(frame)];
    }
};

Track make_track(const Body& body, const SharedMatrix& values, double fps, std::string name);

/// Motion in the plane from the frame before to this one; at the ends of the clip, the next step
/// that there is.
Step step_to(const Body& body, const Track& track, std::int64_t frame);

/// How far two postures and their velocities are apart: |dp|^2 + (velocity_s |dv|)^2, squared.
double squared_distance(const Track& a, std::int64_t i, const Track& b, std::int64_t j,
                        double velocity_s);

/// Root of the sum of squares: a ruler for what is small.
double posture_size(const Track& track, std::int64_t frame);

} // namespace stltsa::synthesis
