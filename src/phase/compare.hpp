// SPDX-License-Identifier: BSD-3-Clause
// Two mean cycles laid on each other: differences in timing and amplitude, and how well they are
// known.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "phase/estimate.hpp"
#include "phase/resample.hpp"

namespace stltsa::phase {

/// Of some columns, such as the coordinates of a joint. Unknown fields are NaN.
struct PartDifference {
    double rms = 0;    ///< root mean square over the cycle of second less first
    double chance = 0; ///< `rms` expected from the spread of the cycles if there is no difference
    double correlation = 0; ///< of the curves after the lag is removed
    /// Delay of the second curve in the cycle, as a share of it; unknown if the curves are not
    /// alike. `first` is 0; the standard deviations are those of the timing of single cycles.
    Estimate lag;
    /// Of the mean curve: the distance of its two places that are farthest apart.
    Estimate amplitude;
    Estimate ratio; ///< of second to first; only difference, low and high, which are ratios
    Estimate mean;  ///< over the cycle; of one column only
};

struct Differences {
    double shift = 0; ///< lag of all columns together, as a share of the cycle: 0 once aligned
    Estimate whole;   ///< its spread: error and interval of the alignment
    double likeness = 0, runner_up = 0;  ///< correlations of the whole body
    std::vector<PartDifference> parts;   ///< of each group
    std::vector<PartDifference> columns; ///< of each column
    Matrix difference, error, margin;    ///< samples x columns
};

/// `groups`: of each column, from 0 on. Without missing samples. `paired`: cycle k of both is the
/// same cycle, and lags count from it; otherwise lags are relative to that of all columns together,
/// whose error is part of theirs.
Differences compare(const Resampled& first, const Resampled& second,
                    std::span<const std::int64_t> groups, bool paired);

/// The samples of mean curves over one cycle, the last of which repeats the first, without it.
Matrix once_around(const Matrix& samples);

} // namespace stltsa::phase
