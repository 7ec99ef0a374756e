// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/footing.hpp"

#include <algorithm>
#include <numeric>

namespace stltsa::synthesis {
namespace {

/// Squared speed, relative to the mean over the joints, below which joints have about equal weight.
constexpr double still = 0.0025;

Vec3 posture(const Track& track, std::int64_t frame, std::int64_t joint) {
    const double* p = track.postures.row(frame) + 3 * joint;
    return {p[0], p[1], p[2]};
}

Vec3 place(const Track& track, std::int64_t frame, std::int64_t joint) {
    const RootState& root = track.root(frame);
    return root.position + rotate(root.yaw, posture(track, frame, joint));
}

double squared_speed(const Track& track, std::int64_t frame, std::int64_t joint) {
    const std::int64_t to = std::min(std::max<std::int64_t>(frame, 1), track.frames() - 1);
    const Vec3 displacement =
        place(track, to, joint) - place(track, std::max<std::int64_t>(to - 1, 0), joint);
    return clip::dot(displacement, displacement);
}

} // namespace

Vec3 standing_offset(const Track& earlier, std::int64_t a, const Track& later, std::int64_t b) {
    const std::int64_t joints = earlier.postures.cols() / 3;
    std::vector<double> speeds;
    for (std::int64_t j = 0; j < joints; ++j)
        speeds.push_back(squared_speed(earlier, a, j) + squared_speed(later, b, j));
    const double mean =
        std::accumulate(speeds.begin(), speeds.end(), 0.0) / static_cast<double>(joints);
    Vec3 sum{};
    double weights = 0;
    for (std::int64_t j = 0; j < joints; ++j) {
        const double speed = mean > 0 ? speeds[static_cast<std::size_t>(j)] / mean : 0;
        const double weight = 1 / ((speed + still) * (speed + still));
        sum = sum + weight * (posture(later, b, j) - posture(earlier, a, j));
        weights += weight;
    }
    return (1 / weights) * sum;
}

} // namespace stltsa::synthesis
