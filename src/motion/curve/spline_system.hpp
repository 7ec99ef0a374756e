// SPDX-License-Identifier: BSD-3-Clause
// Penalized least squares with cubic B-splines over equally spaced rows (P-splines: Eilers, Marx,
// "Flexible Smoothing with B-splines and Penalties", Statistical Science 11, 1996).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace stltsa::motion {

/// Minimizes  sum w_i (y_i - f(i))^2 + lambda * sum (second differences of f's coefficients)^2.
/// The time is linear in the rows. Straight lines are reproduced for any lambda.
class SplineSystem {
  public:
    /// `knot_step`: rows between knots, at least 1; adjusted so that there is a knot at both ends.
    SplineSystem(std::int64_t rows, double knot_step);

    /// The adjusted rows between knots, which set the scale of lambda.
    double knot_step() const { return step_; }
    std::int64_t coefficients() const { return intervals_ + 3; }

    /// Sets the data to fit; weights are not negative.
    void set_data(std::span<const double> values, std::span<const double> weights);

    struct Fit {
        std::vector<double> curve;     ///< f at each row
        double degrees_of_freedom = 0; ///< trace of the matrix that maps the values to the curve
    };
    Fit fit(double lambda) const;

  private:
    /// A column of a symmetric matrix of half bandwidth 3: the diagonal and the entries below it.
    using Column = std::array<double, 4>;
    /// Three columns of zeros follow the last one, so that no loop needs to check for the end.
    using Band = std::vector<Column>;

    struct Basis {
        std::size_t first;            ///< coefficient of the first of four B-splines
        std::array<double, 4> values; ///< the four that are not zero at a row
    };
    Basis basis(std::int64_t row) const;
    Band penalized(double lambda) const;
    std::vector<double> curve(const std::vector<double>& coefficients) const;
    double degrees_of_freedom(const Band& factor) const;
    static void factor(Band& matrix);
    static void solve(const Band& factor, std::vector<double>& x);

    std::int64_t rows_;
    std::int64_t intervals_;
    double step_;
    Band normal_;               ///< B^T W B
    std::vector<double> right_; ///< B^T W y
};

} // namespace stltsa::motion
