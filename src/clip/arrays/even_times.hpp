// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Rates with a smaller relative difference are one: 29.97 and 30.
constexpr double same_rate = 0.01;

/// The steps between times.
struct TimeSteps {
    double least = 0, median = 0, most = 0, mean = 0;
    double usual = 0;   ///< of rows that follow one another
    double longest = 0; ///< a longer step is a gap: at least one row is missing

    explicit TimeSteps(std::span<const double> times);

    /// Even except for times rounded to a few digits. A missing row would cause a double step.
    bool even() const;
};

/// Whether the times are those of even rows, rounded to a unit as large as their steps, so that
/// some of the steps are twice as long as others, or 0.
bool are_rounded(std::span<const double> times);

/// Whether all steps are equal, except for the digits with which the times were written.
bool are_equal_steps(std::span<const double> times);

/// What tells the places of rows in time.
struct Clock {
    std::span<const double> times;        ///< seconds, increasing; two or more
    std::span<const std::int64_t> counts; ///< of rows, from 0, increasing; empty: not counted
    double fps = 0;                       ///< said beside the times; 0: nothing is said
    int width = 1;                        ///< columns of a group, which may be missing
};

/// Rows at a constant rate.
struct EvenRows {
    Matrix rows;
    double fps = 0;
    std::string note; ///< what was done; empty: the rows are those given
};

/// Rows at increasing times. The rate is that of all rows, from the first to the last; of the rates
/// that the digits of the times leave open, that which is said, or a whole one. Rows that are
/// missing, by the counts or the times, are NaN. Rows at uneven times are resampled linearly, at
/// the rate of the usual step, or of the mean if steps vary slowly. Throws Status::format with
/// `where` before the text if more rows are missing than there are.
EvenRows even_rows(Matrix rows, const Clock& clock, const std::string& where);

/// Rows at their counts, the others NaN; without a rate. Throws as even_rows.
EvenRows counted_rows(Matrix rows, std::span<const std::int64_t> counts, const std::string& where);

} // namespace stltsa::clip
