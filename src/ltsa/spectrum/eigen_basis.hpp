// SPDX-License-Identifier: BSD-3-Clause
// Approximate eigenvectors of an alignment matrix, and their correction.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"
#include "linalg/panel.hpp"
#include "ltsa/alignment/alignment.hpp"

namespace stltsa::ltsa {

/// The vectors in both forms, as panels: x is the prolongation of the unknowns. The workspace is
/// allocated once, because fresh memory costs as much as the work on it.
struct EigenBasis {
    EigenBasis(const Alignment& alignment, std::int64_t vectors)
        : count(vectors), unknowns(panel(alignment.unknowns())), x(panel(alignment.frames())),
          before(panel(alignment.frames())), product(panel(alignment.unknowns())),
          right(panel(alignment.unknowns())) {}

    std::int64_t count;
    Matrix unknowns, x;
    Matrix before;              ///< x before the last correction
    Matrix product;             ///< B' times the unknowns, or their residual
    Matrix right;               ///< S^T x for that residual
    std::vector<double> values; ///< ascending, after rayleigh_ritz()

  private:
    Matrix panel(std::int64_t rows) const { return Matrix::unset(rows, panel_width(count)); }
};

/// The factor that makes the columns of basis.x orthonormal. Nearly parallel columns would cost
/// digits, so they are first multiplied by such factors until they are not.
Matrix orthonormal_factor(const Alignment& alignment, EigenBasis& basis);

/// Replaces the basis by the best eigenvectors in its span.
void rayleigh_ritz(const Alignment& alignment, EigenBasis& basis);

/// One inverse iteration as a correction: z - F^-1 (B' z - lambda S^T x), which is lambda B'^-1 S^T
/// x for F = B'. The residual is computed from the patches, so neither the rounding of B' and its
/// factor F nor a shift in F limits the accuracy.
void correct(const Alignment& alignment, EigenBasis& basis);

/// The sine of the largest principal angle by which the span of the first `count` vectors turned
/// since the last correction.
double last_turn(const EigenBasis& basis, std::int64_t count, const Machine& machine);

/// Largest ||B u - lambda u|| / k over the first `count` vectors; overwrites `product` and
/// `before`.
double largest_residual(const Alignment& alignment, EigenBasis& basis, std::int64_t count);

} // namespace stltsa::ltsa
