// SPDX-License-Identifier: BSD-3-Clause
// Finds where the body stands still.
#pragma once

#include <span>
#include <vector>

namespace stltsa::motion {

/// [begin, end) in samples, not rounded.
struct Rest {
    double begin = 0;
    double end = 0;
};

/// Definition of standing still.
struct Standing {
    double below = 0; ///< upper limit of the speed
    double hold = 0;  ///< least duration in samples
    /// Speed above which even a perfectly still body counts as moving. Smoothing makes the speed
    /// rise before the body starts; it reaches this value at about the start.
    double still = 0;
};

/// Ranges where `speed` stays below the limit for long enough, at the ends of the clip too: slow
/// samples there may only be a turning point of the motion at which the clip was cut. The ranges
/// are shortened to where the speed exceeds that of standing: two standard deviations above its
/// median, and at least `still`.
std::vector<Rest> find_rests(std::span<const double> speed, const Standing& standing);

} // namespace stltsa::motion
