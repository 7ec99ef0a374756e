// SPDX-License-Identifier: BSD-3-Clause
// How well the motion repeats, for each time and lag: the correlation of the velocities of the pose
// a lag apart, in a window of about two lags. Velocities have no mean to remove, and slow sway has
// little of them.
#pragma once

#include <vector>

#include "motion/period/signal.hpp"

namespace stltsa::motion {

struct LagMap {
    std::vector<double> lags; ///< rows, ascending, about 3 % apart
    std::vector<float> match; ///< times x lags, -1 to 1; see at()
    std::int64_t times = 0;
    std::int64_t hop = 1; ///< time t is row hop * t of the range

    float at(std::int64_t time, std::size_t lag) const {
        return match[static_cast<std::size_t>(time) * lags.size() + lag];
    }
};

/// Lags from `shortest` to `longest` rows.
LagMap make_lag_map(const Signal& signal, Rows range, double shortest, double longest);

} // namespace stltsa::motion
