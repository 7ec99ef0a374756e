// SPDX-License-Identifier: BSD-3-Clause
// The alignment matrix B of one component in a basis where it has no null vector, factored.
//
// B e = 0 holds exactly, and the eigenvalues that are wanted are tiny (1e-13 for a million
// frames), so B plus a shift, factored, keeps few digits or none. Both classes below solve with
// B on the complement of e instead.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "linalg/matrix.hpp"
#include "ltsa/patches.hpp"

namespace stltsa::ltsa {

class Alignment {
  public:
    explicit Alignment(const Patches& patches) : patches_(&patches) {}
    virtual ~Alignment() = default;

    std::int64_t frames() const { return patches_->frames(); }
    std::int64_t unknowns() const { return patches_->frames() - 1; }

    /// The right-hand side that values x at the frames (of zero mean) become in the unknowns.
    virtual void restrict_to(std::span<const double> x, std::span<double> unknowns) const = 0;
    /// Values at the frames, of zero mean, from unknowns.
    virtual void prolong(std::span<const double> unknowns, std::span<double> x) const = 0;
    /// Solves with the factor, in place.
    virtual void solve(std::span<double> unknowns) const = 0;
    /// out := B' in, through the patches, never through the rounded matrix: what the
    /// refinement's residuals rest on.
    void apply(std::span<const double> in, std::span<double> out) const;
    /// The patch's part of unknowns: values at its frames up to a constant, k entries.
    virtual void gather(std::int64_t patch, std::span<const double> unknowns,
                        double* values) const = 0;
    /// The transpose of gather(), added to what is there.
    virtual void scatter(std::int64_t patch, const double* values,
                         std::span<double> unknowns) const = 0;

    const Patches& patches() const { return *patches_; }

  protected:
    const Patches* patches_;
};

/// For temporal neighborhoods: unknowns z_c = x_{c+1} - x_c, banded, envelope Cholesky.
std::unique_ptr<Alignment> difference_alignment(const Patches& patches, int threads);

/// For neighborhoods that are not banded: the last frame grounded, CHOLMOD.
/// Throws Status::unsupported in a build without CHOLMOD.
std::unique_ptr<Alignment> grounded_alignment(const Patches& patches);

/// Subtracts the mean.
void center(std::span<double> x);

} // namespace stltsa::ltsa
