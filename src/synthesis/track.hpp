// SPDX-License-Identifier: BSD-3-Clause
// A clip prepared for joining: postures, their distances, and the state of the root.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synthesis/root.hpp"

namespace stltsa::synthesis {

struct Track {
    std::string name; ///< the clip's name, for messages
    Matrix values;    ///< channels, at the frame rate of the new clip
    double fps = 0;
    std::int64_t first = 0; ///< number of T-pose frames at the start
    std::vector<RootState> roots;
    /// Positions of the joints relative to the body root and its heading, and velocities per
    /// second. The last row, beyond the frames, extrapolates the motion.
    Matrix postures;
    Matrix velocities;

    std::int64_t frames() const { return values.rows(); }
    const RootState& root(std::int64_t frame) const {
        return roots[static_cast<std::size_t>(frame)];
    }
};

Track make_track(const Body& body, const Matrix& values, double fps, std::string name);

/// Motion in the plane from the previous frame to this one, or the nearest step of the clip.
Step step_to(const Body& body, const Track& track, std::int64_t frame);

/// Squared distance of two postures and their velocities: |dp|^2 + (velocity_s |dv|)^2.
double squared_distance(const Track& a, std::int64_t i, const Track& b, std::int64_t j,
                        double velocity_s);

/// Norm of a posture: the unit for thresholds on small differences.
double posture_size(const Track& track, std::int64_t frame);

} // namespace stltsa::synthesis
