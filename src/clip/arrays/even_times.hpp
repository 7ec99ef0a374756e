// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// The steps between times.
struct TimeSteps {
    double least = 0, median = 0, most = 0, mean = 0;
    double usual = 0;   ///< of rows that follow one another
    double longest = 0; ///< a longer step is a gap: at least one row is missing

    explicit TimeSteps(std::span<const double> times);

    /// Even except for times rounded to a few digits. A missing row would cause a double step.
    bool even() const { return least >= 0.5 * median && most <= 1.5 * median; }
    /// Consecutive integers such as 5, 6, 7.
    bool count() const { return least == 1 && most == 1; }
};

/// Rows at a constant rate.
struct EvenRows {
    Matrix rows;
    double fps = 0;
    std::string note; ///< what was done; empty: the rows are those given
};

/// Rows at increasing times, in seconds. If the steps are uneven, they are resampled linearly at
/// the rate of the usual step; where rows are missing, their values are NaN. Throws Status::format
/// with `where` before the text if more rows are missing than there are.
EvenRows even_rows(Matrix rows, std::span<const double> times, const std::string& where);

} // namespace stltsa::clip
