// SPDX-License-Identifier: BSD-3-Clause
// Speed of the body at each sample, relative to the typical speed of the clip.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// Whether a sample of this activity level counts as motion.
bool is_moving(double level);

struct Activity {
    std::vector<double> speed; ///< of the pose, in feature units per sample
    double typical = 0; ///< half of the distance is covered at this speed or faster; 0: no motion
    std::vector<double> level; ///< speed / typical, at most 1: the weight of a sample

    std::int64_t samples() const { return static_cast<std::int64_t>(speed.size()); }
    bool moving(std::int64_t sample) const {
        return is_moving(level[static_cast<std::size_t>(sample)]);
    }
};

/// Change of the pose per sample, after smoothing by `sigma` samples. `poll`: called periodically;
/// may throw to stop.
std::vector<double> pose_speed(ConstMatrixView samples, double sigma,
                               const std::function<void()>& poll = {});

Activity measure_activity(ConstMatrixView samples, double fps,
                          const std::function<void()>& poll = {});

} // namespace stltsa::motion
