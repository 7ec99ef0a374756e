// SPDX-License-Identifier: BSD-3-Clause
// Rows and segments in a few coordinates, whose distances are at most the true ones. Motion varies
// in few directions, so a search needs all features of few rows only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::ltsa {

/// The segment from a row to the next, or a single row, which is its own next.
struct Segment {
    std::int32_t row, next;
};

/// The coordinates z of each row along the directions in which the rows vary most, and, as the last
/// column, the length r of the remainder: |x - y|^2 >= |z_x - z_y|^2 + (r_x - r_y)^2.
class ReducedRows {
  public:
    ReducedRows() = default;
    /// Of these rows of x, in this order.
    ReducedRows(ConstMatrixView x, std::span<const std::int32_t> rows);

    ConstMatrixView view() const { return reduced_.view(); }

    struct Query {
        AlignedVector<double> reduced;
        double error; ///< rounding may lengthen a distance by this much
    };
    Query reduce(const double* row) const;

    /// At most the squared distance from the query to row i.
    double bound(const Query& query, std::int64_t i) const;

  private:
    double put(const double* row, AlignedVector<double>& remainder, double* out) const;

    AlignedVector<double> mean_;
    Matrix basis_; ///< orthonormal rows
    Matrix reduced_;
    double size_ = 0; ///< largest distance of a row from the mean
};

/// Segments between reduced rows. The length of the remainder is not linear along a segment: it is
/// at most what interpolation says, and at least that minus half the distance of the remainders.
class ReducedSegments {
  public:
    ReducedSegments() = default;
    /// `reduced`: those of the rows of x where the segments begin, which must outlive this.
    ReducedSegments(ConstMatrixView x, std::span<const Segment> segments, ConstMatrixView reduced);

    /// A ball of margins()[i] around row i of middles() contains segment i.
    ConstMatrixView middles() const { return middles_.view(); }
    std::span<const double> margins() const { return margins_; }

    /// At most the squared distance from the query to segment i. Far from close if that is larger
    /// than `reach`, which is squared, too.
    double bound(const ReducedRows::Query& query, std::int64_t i, double reach) const;

  private:
    ConstMatrixView reduced_;
    std::vector<std::int32_t> next_; ///< row of `reduced` where each segment ends
    Matrix middles_;
    std::vector<double> margins_;
};

} // namespace stltsa::ltsa
