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

/// Stretches where `speed` stays below `level` for at least `hold` samples (half of that at the
/// ends of the clip), cut back to where the speed rises out of the standing itself: two standard
/// deviations above its median, and at least to a small share of `reference`, the speed of the
/// motion.
std::vector<Rest> find_rests(std::span<const double> speed, double level, double reference,
                             double hold);

} // namespace stltsa::motion
