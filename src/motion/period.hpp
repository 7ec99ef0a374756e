// SPDX-License-Identifier: BSD-3-Clause
// After which time the motion repeats itself.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "linalg/matrix.hpp"
#include "motion/activity.hpp"

namespace stltsa::motion {

struct Period {
    double samples = 0; ///< 0: none found
    double quality = 0; ///< 1 - D(samples), see lag_curve(); 0 without a period
};

/// Samples about their mean, at no more than about 30 a second: motion holds nothing that fewer
/// would miss, and the lag curve takes lags x samples.
struct LagSamples {
    LagSamples(ConstMatrixView samples, std::span<const double> levels, double fps);

    std::int64_t step = 1; ///< source samples per row
    Matrix x;
    std::vector<double> level; ///< activity
    std::vector<double> norm;  ///< |x|^2
};

/// D(lag) for lag = first .. last rows: how far the rows are from those `lag` later, over how far
/// both are from their means, D = sum w |(x'-m') - (x-m)|^2 / sum w (|x'-m'|^2 + |x-m|^2), with
/// x' = x_{t+lag} and w the product of both activities, so that standing does not count.
/// 0: the same motion again; 1: unrelated; 2: the opposite.
std::vector<double> lag_curve(const LagSamples& samples, std::int64_t first, std::int64_t last,
                              const Progress& progress = {});

/// The longest lag that a clip of so many samples can be compared at, up to `longest_s`.
double longest_lag_s(std::int64_t samples, double fps, double longest_s);

/// The first lag, of `shortest_s` to `longest_s` seconds, that is about as good as the best. It is
/// the first half of the stage "neighbors".
Period find_period(ConstMatrixView samples, const Activity& activity, double fps, double shortest_s,
                   double longest_s, const Progress& progress = {});
/// The same for samples whose activity is not known.
Period find_period(ConstMatrixView samples, double fps, double shortest_s, double longest_s,
                   const Progress& progress = {});

/// The period of a stretch of the samples that is known to be near `period`; none where the
/// stretch is too short to tell, or repeats nowhere near it.
std::optional<Period> refine_period(ConstMatrixView stretch, std::span<const double> level,
                                    double period, double fps);

} // namespace stltsa::motion
