// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/random.hpp"
#include "linalg/aggregation.hpp"
#include "linalg/arpack.hpp"
#include "linalg/panel.hpp"
#include "ltsa/eigen_basis.hpp"

namespace stltsa::ltsa {
namespace {

/// y := Q^T B^+ Q x for a panel or one column, x or another; the unknowns of B^+ Q x are left, too.
void multiply_by_inverse(const Alignment& alignment, const Aggregation& runs, ConstMatrixView x,
                         MatrixView unknowns, MatrixView y) {
    alignment.restrict_to(runs, x, unknowns);
    alignment.solve(unknowns);
    alignment.prolong(unknowns, runs, y);
}

/// x := B^+ x
void multiply_by_inverse(const Alignment& alignment, MatrixView x, MatrixView unknowns) {
    multiply_by_inverse(alignment, {alignment.frames(), 1}, x, unknowns, x);
}

/// x -> Q^T B^+ Q x, a mean and a slope for each run of frames: the wanted eigenpairs are its
/// largest, so no shift is needed.
Operator pseudo_inverse(const Alignment& alignment, const Aggregation& runs) {
    return [&alignment, runs, unknowns = Matrix::unset(alignment.unknowns(), 1)](
               std::span<const double> x, std::span<double> y) mutable {
        multiply_by_inverse(alignment, runs, {x.data(), runs.columns(), 1, 1}, unknowns.view(),
                            {y.data(), runs.columns(), 1, 1});
    };
}

/// ARPACK always gets this start vector: its own are different on every call. Running sums of noise
/// are mostly slow, as the wanted vectors are: one solve less, where rows are in order of time.
void set_start(const Aggregation& runs, std::span<double> x) {
    std::ranges::fill(x, 0.0);
    const MatrixView means{x.data(), runs.runs(), 1, runs.terms()};
    Random random(1);
    for (std::int64_t run = 0; run < runs.runs(); ++run)
        means(run, 0) = random.symmetric();
    center(means, {Simd::baseline, 1});
    for (std::int64_t run = 1; run < runs.runs(); ++run)
        means(run, 0) += means(run - 1, 0);
    center(means, {Simd::baseline, 1});
}

/// A correction that turns the embedding by less than this is the last one: in differences the
/// first, which is a certificate; grounded, two or three are needed.
constexpr double small_change = 1e-12;
constexpr int most_corrections = 12;
/// One that turns it by more than this share of what the one before did is of no use.
constexpr double least_progress = 0.8;

/// Solves that bring ARPACK's vectors as near: a correction has one of them, and passes through
/// the patches beside. One in any case, because it makes unknowns: differences of a vector's
/// entries would lose as many digits as the entries are larger than their differences.
int first_solves(const Eigenpairs& found, std::int64_t dimension) {
    constexpr int most_solves = 4; // corrections say how far they come
    const auto pairs = static_cast<std::size_t>(found.coefficients.cols());
    const double last = found.values[static_cast<std::size_t>(dimension) - 1];
    const double beyond = pairs < found.values.size() ? std::max(found.values[pairs], 0.0) : 0;
    double angle = found.errors[static_cast<std::size_t>(dimension) - 1] / (last - beyond);
    int solves = 0;
    do {
        ++solves;
        angle *= beyond / last; // what a solve leaves of a vector that the basis lacks
    } while (!(angle < small_change) && solves < most_solves);
    return solves;
}

/// What ARPACK found, solved for so many times.
EigenBasis solved(const Alignment& alignment, const Aggregation& runs, const Eigenpairs& found,
                  int times) {
    EigenBasis basis(alignment, found.coefficients.cols());
    Matrix coarse = Matrix::unset(runs.columns(), basis.x.cols());
    combine_rows(found.basis.view(), found.coefficients, coarse.view(), alignment.machine());
    runs.spread(coarse.view(), basis.x.view(), alignment.machine());
    for (int i = 0; i < times; ++i) {
        if (i > 0) // else the largest eigenvalue would soon leave one vector in all of them
            multiply_columns(basis.x.view(), orthonormal_factor(alignment, basis),
                             alignment.machine());
        multiply_by_inverse(alignment, basis.x.view(), basis.unknowns.view());
    }
    return basis;
}

/// Whether vectors that are straight over these runs are enough to look among: false where one may
/// be wanted that mostly varies within runs. It might be in nothing that follows, not even as an
/// error that grows. But B^+ times noise of variance 1 has each eigenvector in it about as large as
/// its eigenvalue of B^+, which is at least `smallest_wanted` for a wanted one.
bool enough(const Alignment& alignment, const Aggregation& runs, double smallest_wanted) {
    constexpr double small_share = 1e-3; // what motion has within runs stays below
    Matrix noise = Matrix::unset(alignment.frames(), 1);
    Matrix unknowns = Matrix::unset(alignment.unknowns(), 1);
    for_row_blocks(noise.rows(), alignment.machine(),
                   [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
                       Random random(2 + static_cast<std::uint64_t>(block));
                       for (std::int64_t i = first; i < first + rows; ++i)
                           noise(i, 0) = std::sqrt(3.0) * random.symmetric();
                   });
    multiply_by_inverse(alignment, noise.view(), unknowns.view());
    return runs.variation_within(noise.view(), 0, alignment.machine()) <
           small_share * smallest_wanted;
}

/// The first vectors, one per row.
Matrix rows_of(const Matrix& panel, std::int64_t count, const Machine& machine) {
    Matrix rows = Matrix::unset(count, panel.rows());
    for_row_blocks(panel.rows(), machine,
                   [&](std::int64_t, std::int64_t first, std::int64_t block) {
                       for (std::int64_t j = 0; j < count; ++j)
                           for (std::int64_t i = first; i < first + block; ++i)
                               rows(j, i) = panel(i, j);
                   });
    return rows;
}

/// Corrects until that turns the embedding no more.
void refine(const Alignment& alignment, std::int64_t dimension, const Progress& progress,
            EigenBasis& basis, Spectrum& spectrum) {
    double before = 2;
    for (int i = 0; i < most_corrections; ++i) {
        progress.report(Stage::spectrum, 0.5);
        correct(alignment, basis);
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

/// From vectors that are straight over these runs; nothing where they turn out not to be enough.
std::optional<Spectrum> eigenpairs_from(const Alignment& alignment, const Aggregation& runs,
                                        std::int64_t count, std::int64_t dimension,
                                        const Progress& progress, std::int64_t& solves) {
    // Where a first correction turns the embedding by more, runs were too long for it.
    constexpr double change_by_runs = 1e-9;
    const bool fewer = runs.runs() < runs.rows();
    Eigenpairs found = largest_eigenpairs(
        pseudo_inverse(alignment, runs), runs.columns(),
        [&](std::span<double> x) { set_start(runs, x); }, count, alignment.machine(),
        [&] { progress.report(Stage::spectrum, 0.0); });
    solves += found.applications;
    if (fewer && !enough(alignment, runs, found.values[static_cast<std::size_t>(dimension) - 1]))
        return {};
    Spectrum spectrum;
    const int times = first_solves(found, dimension);
    EigenBasis basis = solved(alignment, runs, std::exchange(found, {}), times);
    rayleigh_ritz(alignment, basis);
    refine(alignment, dimension, progress, basis, spectrum);
    if (fewer && !(spectrum.first_change < change_by_runs))
        return {};
    spectrum.residual = largest_residual(alignment, basis, dimension);
    spectrum.values = basis.values;
    spectrum.vectors = rows_of(basis.x, dimension, alignment.machine());
    progress.report(Stage::spectrum, 1.0);
    return spectrum;
}

} // namespace

Spectrum smallest_eigenpairs(const Alignment& alignment, std::int64_t count, std::int64_t dimension,
                             std::int64_t run_length, const Progress& progress) {
    const std::int64_t n = alignment.frames();
    std::int64_t solves = 0;
    auto spectrum = eigenpairs_from(alignment, {n, run_length}, count, dimension, progress, solves);
    if (!spectrum)
        spectrum = eigenpairs_from(alignment, {n, 1}, count, dimension, progress, solves);
    spectrum->solves = solves;
    return std::move(*spectrum);
}

} // namespace stltsa::ltsa
