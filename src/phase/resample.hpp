// SPDX-License-Identifier: BSD-3-Clause
// Signals of any kind on 0 to 100 % of each cycle, with mean and spread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "phase/phases.hpp"

namespace stltsa::phase {

/// Rows at which each cycle, from border to border, passes even phases: cycles x samples, the last
/// sample being the first of the next cycle. `shift`: as a share of the cycle; samples begin there
/// and go on, after the end of the cycle, at its beginning.
Matrix times_of(const Run& run, const Borders& borders, std::int64_t samples, double shift = 0);

/// Where samples of cycles lie.
struct Turns {
    Matrix rows; ///< cycles x samples, not rounded; NaN: unknown
    /// Empty, or for each cycle the rows that it repeats: the row after the last of them is the
    /// first one. An empty range: nothing is repeated.
    std::vector<Range> repeated;
};

/// The same as times_of() without registration: linear in time between the borders.
Matrix times_between(const Borders& borders, std::int64_t samples);

struct Resampled {
    Matrix rows;              ///< of each sample of each cycle
    Matrix warp;              ///< share of the cycle by which a phase comes later than linear time
    std::vector<Matrix> each; ///< samples x columns
    Matrix mean, deviation;   ///< over the cycles; standard deviation, NaN of a single one
    Matrix distance;          ///< cycles x columns, root mean square about the mean, in its unit
    /// Of all columns, as a share of the root of their variance over the mean cycle.
    std::vector<double> total;
    std::string no_halves; ///< the reason if left and right cannot be compared; else empty
};

/// Distances of groups of columns, such as the coordinates of each joint, cycles x groups: the root
/// of the sum of squares over the columns of known distance. `groups`: of each column, -1 for none.
Matrix group_distance(const Resampled& of, std::span<const std::int64_t> groups);

/// `signals`: a row each; NaN is a missing value and is left out of means. Linear between rows. A
/// row that is NaN, or beyond the last one, has no values.
Resampled resample(ConstMatrixView signals, Turns turns);

/// The same of cycles that are resampled already; `rows`: of each sample of each cycle.
Resampled spread_of(Matrix rows, std::vector<Matrix> each);

} // namespace stltsa::phase
