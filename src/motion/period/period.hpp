// SPDX-License-Identifier: BSD-3-Clause
// The period of a motion.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "motion/period/activity.hpp"

namespace stltsa::motion {

struct Period {
    double samples = 0; ///< 0: none found
    double quality = 0; ///< 1 - D(samples), see lag_curve(); 0 without a period
};

/// Samples minus their mean, decimated to about 30 per second: enough for human motion, and the
/// cost of the lag curve is lags x samples.
struct LagSamples {
    LagSamples(ConstMatrixView samples, std::span<const double> levels, double fps,
               const Progress& progress = {});

    std::int64_t step = 1; ///< source samples per row
    Matrix x;
    std::vector<double> level; ///< activity
    std::vector<double> norm;  ///< |x|^2
};

/// Normalized distance D(lag), for lag = first .. last, of the rows from those `lag` rows later:
/// D = sum w |(x'-m') - (x-m)|^2 / sum w (|x'-m'|^2 + |x-m|^2), with x' = x_{t+lag}, the means m
/// and m', and w the product of both activity levels, so that standing does not count.
/// 0: the motion repeats; 1: unrelated; 2: the opposite motion.
std::vector<double> lag_curve(const LagSamples& samples, std::int64_t first, std::int64_t last,
                              const Progress& progress = {});

/// The shortest lag from `shortest_s` to `longest_s` seconds that is about as good as the best lag.
/// Reports progress as the first half of the stage "neighbors".
Period find_period(ConstMatrixView samples, const Activity& activity, double fps, double shortest_s,
                   double longest_s, const Progress& progress = {});
/// The same, measuring the activity of the samples first.
Period find_period(ConstMatrixView samples, double fps, double shortest_s, double longest_s,
                   const Progress& progress = {});

} // namespace stltsa::motion
