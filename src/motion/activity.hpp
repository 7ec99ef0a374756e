// SPDX-License-Identifier: BSD-3-Clause
// Speed of the body at each sample, relative to the typical speed of the clip.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
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
    std::span<const double> levels(std::int64_t first, std::int64_t count) const {
        return std::span(level).subspan(static_cast<std::size_t>(first),
                                        static_cast<std::size_t>(count));
    }
};

/// Change of the pose per sample, after smoothing by `sigma` samples. `poll`: called periodically;
/// may throw to stop.
std::vector<double> pose_speed(ConstMatrixView samples, double sigma,
                               const std::function<void()>& poll = {});

Activity measure_activity(ConstMatrixView samples, double fps,
                          const std::function<void()>& poll = {});

/// Samples first to first + count - 1.
struct Span {
    std::int64_t first = 0;
    std::int64_t count = 0;
};

/// From the first moving sample to the last, extended by up to `margin` samples to each side; all
/// samples if nothing moves.
Span moving_span(const Activity& activity, std::int64_t margin);

} // namespace stltsa::motion
