// SPDX-License-Identifier: BSD-3-Clause
#include "motion/period/activity.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "linalg/simd.hpp"
#include "motion/curve/smoothing.hpp"

namespace stltsa::motion {
namespace {

/// Limbs take longer than this to start or stop; capture noise is faster.
constexpr double speed_smoothing_s = 0.1;
/// Below this share of the typical speed a sample does not count as motion. Gait stays above 0.45.
constexpr double moving_level = 0.4;
/// Speeds per sample below this share of the largest value are rounding.
constexpr double rounding = 1e-12;

double largest(ConstMatrixView samples) {
    double size = 0;
    for (std::int64_t i = 0; i < samples.rows; ++i)
        for (std::int64_t c = 0; c < samples.cols; ++c)
            size = std::max(size, std::abs(samples(i, c)));
    return size;
}

/// The median over the distance covered instead of over time: long standing does not lower it.
double typical_speed(std::vector<double> speed) {
    std::sort(speed.begin(), speed.end(), std::greater<>());
    const double distance = std::accumulate(speed.begin(), speed.end(), 0.0);
    double covered = 0;
    for (const double v : speed) {
        covered += v;
        if (covered >= distance / 2)
            return v;
    }
    return 0;
}

} // namespace

std::vector<double> pose_speed(ConstMatrixView samples, double sigma,
                               const std::function<void()>& poll) {
    const Matrix x = smooth(samples, sigma, poll);
    const std::int64_t n = x.rows();
    std::vector<double> speed(static_cast<std::size_t>(n));
    if (n < 3)
        return speed;
    for (std::int64_t i = 1; i + 1 < n; ++i)
        speed[static_cast<std::size_t>(i)] =
            std::sqrt(squared_distance(x.row(i + 1), x.row(i - 1), x.cols())) / 2;
    speed.front() = speed[1];
    speed.back() = speed[speed.size() - 2];
    return speed;
}

bool is_moving(double level) {
    return level > moving_level;
}

Activity measure_activity(ConstMatrixView samples, double fps, const std::function<void()>& poll) {
    Activity activity;
    activity.speed = pose_speed(samples, speed_smoothing_s * fps, poll);
    activity.typical = typical_speed(activity.speed);
    if (activity.typical <= rounding * largest(samples))
        activity.typical = 0;
    activity.level.resize(activity.speed.size());
    if (activity.typical > 0)
        std::transform(activity.speed.begin(), activity.speed.end(), activity.level.begin(),
                       [&](double v) { return std::min(v / activity.typical, 1.0); });
    return activity;
}

} // namespace stltsa::motion
