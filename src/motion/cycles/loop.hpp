// SPDX-License-Identifier: BSD-3-Clause
// A closed curve in the space of the features, as a function of the phase: the mean cycle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

/// A Fourier series of each column: row 0 is the mean, row h the coefficients of cos(2 pi h phase),
/// row H + h those of sin(2 pi h phase), h = 1 .. H. Circular and smooth by construction.
struct Loop {
    Matrix coefficients;

    std::int64_t cols() const { return coefficients.cols(); }
    std::int64_t harmonics() const { return (coefficients.rows() - 1) / 2; }
    void at(double phase, double* values) const;
    /// Also the derivative by the phase, per turn.
    void at(double phase, double* values, double* slope) const;
    /// The same curve with its phase 0 at what was phase `zero`.
    void shift(double zero);
    /// Values at `count` even phases from 0 on.
    Matrix sampled(std::int64_t count) const;
    /// Mean over a turn of the squared distance from the mean.
    double variance() const;
};

/// Row `begin + i` of the samples has the phase `phase[i]`, in turns, unwrapped.
struct Run {
    std::int64_t begin = 0;
    std::vector<double> phase;

    std::int64_t rows() const { return static_cast<std::int64_t>(phase.size()); }
    std::int64_t end() const { return begin + rows(); }
    /// At a row that is not rounded; on a straight line beyond the ends.
    double phase_at(double row) const;
    /// The row at which the rising phase is reached; likewise.
    double row_at(double reached) const;
};

/// Least squares over the rows of all runs, with a small penalty on high harmonics, so that gaps in
/// the phases covered do no harm.
Loop fit_loop(ConstMatrixView rows, std::span<const Run> runs, std::int64_t harmonics);

/// Least harmonics for cycles of so many rows.
std::int64_t harmonics_for(double period);

} // namespace stltsa::motion
