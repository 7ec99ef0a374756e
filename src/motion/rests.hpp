// SPDX-License-Identifier: BSD-3-Clause
// Where the body stands still.
#pragma once

#include <span>
#include <vector>

namespace stltsa::motion {

/// [begin, end) in samples, fractions kept.
struct Rest {
    double begin = 0;
    double end = 0;
};

/// What standing still is.
struct Standing {
    double below = 0; ///< speed
    double hold = 0;  ///< samples
    /// A perfectly still body moves from this speed on. The speed is smoothed, so that it begins to
    /// rise before the body starts; at this speed it rises about at the start.
    double still = 0;
};

/// Stretches where `speed` stays below the limit for long enough, at the ends of the clip too:
/// where a clip is cut at a turning point of the motion, that is no standing. They are cut back to
/// where the speed rises out of the standing itself: two standard deviations above its median, and
/// at least to `still`.
std::vector<Rest> find_rests(std::span<const double> speed, const Standing& standing);

} // namespace stltsa::motion
