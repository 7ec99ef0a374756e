// SPDX-License-Identifier: BSD-3-Clause
// The alignment matrix B of one component in a basis where it has no null vector, factored.
//
// B e = 0 holds exactly, and the eigenvalues that are wanted are tiny (1e-13 for a million
// frames), so B plus a shift, factored, keeps few digits or none. Both classes below solve with
// B on the complement of e instead.
#pragma once

#include <cstdint>
#include <memory>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/alignment/patches.hpp"

namespace stltsa::ltsa {

/// Vectors come as panels, or as one column each.
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
    /// Values at the frames, of zero mean, from unknowns.
    virtual void prolong(ConstMatrixView unknowns, MatrixView x) const = 0;
    /// Solves with the factor, in place, for the first `count` columns.
    void solve(MatrixView unknowns, std::int64_t count) const;

    /// out := B' in, and x^T B x for the x of the first `count` of the unknowns `in`, a panel:
    /// count rows. Through the patches, never through the rounded matrix: what refinement rests on.
    virtual Matrix apply(ConstMatrixView in, MatrixView out, std::int64_t count) const = 0;
    /// The inverse of restrict_to(): values of zero mean at the frames.
    virtual void at_frames(ConstMatrixView right, MatrixView x) const = 0;

    const Patches& patches() const { return *patches_; }

  protected:
    /// The same for right-hand sides that are rows.
    virtual void solve_rows(MatrixView rows) const = 0;

    const Patches* patches_;
    Machine machine_;
};

/// For temporal neighborhoods: unknowns z_c = x_{c+1} - x_c, banded, LAPACK.
std::unique_ptr<Alignment> difference_alignment(const Patches& patches, const Machine& machine);

/// For neighborhoods that are not banded: the last frame grounded, CHOLMOD.
/// Throws Status::unsupported in a build without CHOLMOD.
std::unique_ptr<Alignment> grounded_alignment(const Patches& patches, const Machine& machine);

} // namespace stltsa::ltsa
