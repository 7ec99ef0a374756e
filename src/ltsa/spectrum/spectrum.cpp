// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/spectrum/spectrum.hpp"

#include <utility>

#include "base/progress.hpp"
#include "base/random.hpp"
#include "linalg/arpack.hpp"
#include "linalg/panel.hpp"
#include "ltsa/spectrum/eigen_basis.hpp"

namespace stltsa::ltsa {
namespace {

/// y := B^+ x for the first `count` columns of a panel, also in place; `unknowns` gets those of y.
void multiply_by_inverse(const Alignment& alignment, ConstMatrixView x, std::int64_t count,
                         MatrixView unknowns, MatrixView y) {
    alignment.restrict_to(x, unknowns);
    alignment.solve(unknowns, count);
    alignment.prolong(unknowns, y);
}

/// x -> B^+ x. The wanted eigenpairs of B are its largest, so no shift is needed.
Operator pseudo_inverse(const Alignment& alignment) {
    return [&alignment, unknowns = Matrix::unset(alignment.unknowns(), 1)](
               std::span<const double> x, std::span<double> y) mutable {
        multiply_by_inverse(alignment, {x.data(), alignment.frames(), 1, 1}, 1, unknowns.view(),
                            {y.data(), alignment.frames(), 1, 1});
    };
}

/// ARPACK's start vector, always the same: those that it chooses differ from call to call.
void set_start(std::span<double> x) {
    Random random(1);
    for (double& value : x)
        value = random.symmetric();
}

/// Solves with ARPACK's vectors before the first correction, because a solve is cheaper: after two,
/// the first correction turns embeddings of recorded clips by less than 1e-10.
constexpr int first_solves = 2;

/// A correction that turns the embedding by less than this is the last one. In differences the
/// first correction usually is, and so certifies the embedding; the grounded form needs two or
/// three.
constexpr double small_change = 1e-12;
constexpr int most_corrections = 12;
/// A correction that turns the embedding by more than this share of the previous turn is the last
/// one: it does not converge.
constexpr double least_progress = 0.8;

/// ARPACK's vectors after two solves. The first is needed in any case, because it gives the
/// unknowns: subtracting a vector's entries would lose digits.
EigenBasis solved(const Alignment& alignment, const Matrix& found) {
    EigenBasis basis(alignment, found.rows());
    set_columns(found, basis.x.view(), alignment.machine());
    for (int i = 0; i < first_solves; ++i) {
        if (i > 0) // else the vectors would approach the one of the largest eigenvalue
            multiply_columns(basis.x.view(), orthonormal_factor(alignment, basis),
                             alignment.machine());
        multiply_by_inverse(alignment, basis.x.view(), basis.count, basis.unknowns.view(),
                            basis.x.view());
    }
    return basis;
}

/// Corrects until the embedding no longer turns.
void refine(const Alignment& alignment, std::int64_t dimension, EigenBasis& basis,
            Spectrum& spectrum) {
    double before = 2;
    for (int i = 0; i < most_corrections; ++i) {
        report_progress(Stage::spectrum, 0.5);
        correct(alignment, basis);
        report_progress(Stage::spectrum, 0.5);
        rayleigh_ritz(alignment, basis);
        const double change = last_turn(basis, dimension, alignment.machine());
        if (i == 0)
            spectrum.first_change = change;
        spectrum.last_change = change;
        if (change < small_change || change > least_progress * before)
            break;
        before = change;
    }
}

} // namespace

Spectrum smallest_eigenpairs(const Alignment& alignment, std::int64_t count,
                             std::int64_t dimension) {
    Call::reach(Stage::spectrum, 0); // the callback must not fit in this stage: see ArpackLock
    Eigenpairs found =
        largest_eigenpairs(pseudo_inverse(alignment), alignment.frames(), set_start, count);
    Spectrum spectrum;
    spectrum.solves = found.applications;
    EigenBasis basis = solved(alignment, std::exchange(found, {}).vectors);
    report_progress(Stage::spectrum, 0.5);
    rayleigh_ritz(alignment, basis);
    refine(alignment, dimension, basis, spectrum);
    report_progress(Stage::spectrum, 0.5);
    spectrum.residual = largest_residual(alignment, basis, dimension);
    spectrum.values = basis.values;
    spectrum.vectors = rows_of(basis.x.view(), dimension, alignment.machine());
    report_progress(Stage::spectrum, 1.0);
    return spectrum;
}

} // namespace stltsa::ltsa
