// SPDX-License-Identifier: BSD-3-Clause
// Velocity and acceleration between the rows.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::phase {

/// Velocity and half the acceleration of rows smoothed by 10 ms, scaled such that of an oscillation
/// once per period they are as large as the pose. Between rows a cubic spline, because events are
/// found to a fraction of a frame.
class FineRows {
  public:
    /// `rate`: rows per second; `period`: rows.
    FineRows(ConstMatrixView rows, double rate, double period);

    std::int64_t rows() const { return values_.rows(); }
    std::int64_t cols() const { return values_.cols(); }
    /// Places per row, such that there are at least 100 a second.
    std::int64_t places() const { return places_; }
    /// Values at a place, which is clamped to the rows.
    void at(double row, double* values) const;

  private:
    Matrix values_;
    Matrix bends_; ///< second derivatives of the spline at the rows
    std::int64_t places_;
};

} // namespace stltsa::phase
