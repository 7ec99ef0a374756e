// SPDX-License-Identifier: BSD-3-Clause
// Two mean cycles, aligned by phase: differences in timing and amplitude, and how precisely they
// are known.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "phase/estimate.hpp"
#include "phase/resample.hpp"

namespace stltsa::phase {

/// Of some columns, such as the coordinates of a joint. Unknown fields are NaN.
struct PartDifference {
    double rms = 0;         ///< root mean square, over the cycle, of second minus first
    double chance = 0;      ///< `rms` expected from the spread between cycles alone
    double correlation = 0; ///< of the curves after the lag is removed
    /// Delay of the second curve in the cycle, as a share of it; unknown if the curves are not
    /// alike. `first` is 0; the standard deviations are those of the timing of single cycles.
    Estimate lag;
    /// Of the mean curve: the distance between its two points that are farthest apart.
    Estimate amplitude;
    /// Of the amplitudes: `difference`, `low` and `high` are ratios, the other fields are unknown.
    Estimate ratio;
    Estimate mean; ///< over the cycle; only of a single column
};

struct Differences {
    double shift = 0; ///< lag of all columns together, as a share of the cycle: 0 once aligned
    Estimate whole;   ///< the same with its error and interval
    double likeness = 0, runner_up = 0;  ///< correlations of the whole body
    std::vector<PartDifference> parts;   ///< of each group
    std::vector<PartDifference> columns; ///< of each column
    Matrix difference, error, margin;    ///< samples x columns
};

/// No sample may be missing. `groups`: the index of the group of each column. `paired`: cycle k is
/// the same cycle in both; otherwise lags are relative to that of all columns together, whose
/// deviations are subtracted from theirs.
Differences compare(const Resampled& first, const Resampled& second,
                    std::span<const std::int64_t> groups, bool paired);

/// Some of the columns.
Matrix chosen(ConstMatrixView from, const std::vector<std::int64_t>& columns);

/// Samples of a cycle without the last one, which repeats the first.
ConstMatrixView once_around(const Matrix& samples);

} // namespace stltsa::phase
