// SPDX-License-Identifier: BSD-3-Clause
// The alignment matrix B of one component (Table 1, step 4), factored in a basis without its null
// vector: B e = 0 exactly, and the wanted eigenvalues are tiny (1e-13 for a million frames), so a
// factor of B plus a shift would lose most of their digits.
#pragma once

#include <cstdint>
#include <memory>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/alignment/patches.hpp"

namespace stltsa::ltsa {

/// Solves with B on the complement of e. Vectors are panels, or single columns.
class Alignment {
  public:
    Alignment(const Patches& patches, const Machine& machine)
        : patches_(&patches), machine_(machine) {}
    virtual ~Alignment() = default;

    std::int64_t frames() const { return patches_->frames(); }
    std::int64_t unknowns() const { return patches_->frames() - 1; }
    const Machine& machine() const { return machine_; }

    /// The right-hand side in the unknowns for values x at the frames, with their mean removed.
    virtual void restrict_to(ConstMatrixView x, MatrixView unknowns) const = 0;
    /// Values at the frames, with zero mean, from unknowns.
    virtual void prolong(ConstMatrixView unknowns, MatrixView x) const = 0;
    /// Solves in place for the first `count` columns.
    void solve(MatrixView unknowns, std::int64_t count) const;

    /// out := B' in. Returns the first `count` rows of x^T B x, with x the prolongation of `in`.
    /// Computed from the patches, not from the rounded matrix, which makes refinement possible.
    virtual Matrix apply(ConstMatrixView in, MatrixView out, std::int64_t count) const = 0;
    /// The inverse of restrict_to(): values at the frames with zero mean.
    virtual void at_frames(ConstMatrixView right, MatrixView x) const = 0;

    const Patches& patches() const { return *patches_; }

  protected:
    /// Solves for right-hand sides that are rows.
    virtual void solve_rows(MatrixView rows) const = 0;

    const Patches* patches_;
    Machine machine_;
};

/// For temporal neighborhoods: B' in differences z_c = x_{c+1} - x_c, banded, factored by LAPACK.
/// No checkpoint is possible during the factorization.
std::unique_ptr<Alignment> difference_alignment(const Patches& patches, const Machine& machine);

/// For any neighborhoods: B without its last row and column (the frame is grounded), sparse,
/// factored by SuiteSparse.
std::unique_ptr<Alignment> grounded_alignment(const Patches& patches, const Machine& machine);

} // namespace stltsa::ltsa
