// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/random.hpp"
#include "linalg/arpack.hpp"
#include "linalg/eigen.hpp"
#include "linalg/panel.hpp"

namespace stltsa::ltsa {
namespace {

/// x -> B^+ x: the wanted eigenpairs are its largest, so no shift is needed.
Operator pseudo_inverse(const Alignment& alignment) {
    return [&alignment, unknowns = Matrix::unset(alignment.unknowns(), 1)](
               std::span<const double> x, std::span<double> y) mutable {
        alignment.restrict_to({x.data(), alignment.frames(), 1, 1}, unknowns.view());
        alignment.solve(unknowns.view());
        alignment.prolong(unknowns.view(), {y.data(), alignment.frames(), 1, 1});
    };
}

/// ARPACK always gets this start vector: its own are different on every call. Running sums of noise
/// are mostly slow, as the wanted vectors are: one solve less, where rows are in order of time.
void set_start(std::span<double> x) {
    const MatrixView vector{x.data(), static_cast<std::int64_t>(x.size()), 1, 1};
    Random random(1);
    for (double& entry : x)
        entry = random.symmetric();
    center(vector, {Simd::baseline, 1});
    std::partial_sum(x.begin(), x.end(), x.begin());
    center(vector, {Simd::baseline, 1});
}

/// Vectors in both forms, as panels: x is the prolongation of the unknowns. Beside them what is
/// computed with them, made once: fresh memory costs as much as the work on it.
struct Basis {
    Basis(const Alignment& alignment, std::int64_t vectors)
        : count(vectors), unknowns(panel(alignment.unknowns(), alignment)),
          x(panel(alignment.frames(), alignment)), before(panel(alignment.frames(), alignment)),
          product(panel(alignment.unknowns(), alignment)),
          right(panel(alignment.unknowns(), alignment)) {}

    std::int64_t count;
    Matrix unknowns, x;
    Matrix before;              ///< x before the last correction
    Matrix product;             ///< B' of the unknowns, until it is made their residual
    Matrix right;               ///< S^T x for that residual
    std::vector<double> values; ///< ascending, once the vectors are the best in their span

  private:
    Matrix panel(std::int64_t rows, const Alignment& alignment) const {
        return Matrix::unset(rows, panel_width(count, alignment.machine().simd));
    }
};

/// (B')^-1 u for each row u. The unknowns of a vector come from a solve, because differences of its
/// entries would lose as many digits as the entries are larger than their differences.
Basis solved(const Alignment& alignment, const Matrix& vectors) {
    Basis basis(alignment, vectors.rows());
    for_row_blocks(basis.x.rows(), alignment.machine(),
                   [&](std::int64_t, std::int64_t first, std::int64_t rows) {
                       for (std::int64_t i = first; i < first + rows; ++i)
                           for (std::int64_t j = 0; j < basis.x.cols(); ++j)
                               basis.x(i, j) = j < basis.count ? vectors(j, i) : 0;
                   });
    alignment.restrict_to(basis.x.view(), basis.unknowns.view());
    alignment.solve(basis.unknowns.view());
    alignment.prolong(basis.unknowns.view(), basis.x.view());
    return basis;
}

/// As many factors as a panel has columns.
Matrix padded(const std::vector<double>& values, std::int64_t width) {
    Matrix result(1, width);
    std::copy(values.begin(), values.end(), result.data());
    return result;
}

/// product := B' z - lambda S^T x of each vector, from B' z.
void make_residual(const Alignment& alignment, Basis& basis) {
    alignment.restrict_to(basis.x.view(), basis.right.view());
    subtract_scaled(basis.right.view(), padded(basis.values, basis.right.cols()),
                    basis.product.view(), alignment.machine());
}

/// One inverse iteration as a correction: z - F^-1 (B' z - lambda S^T x). With F = B' this is
/// lambda B'^-1 S^T x; in floating point the residual goes through the patches, so neither the
/// rounding of B' and its factor F nor a shift in F limits what the iteration converges to.
void correct(const Alignment& alignment, Basis& basis) {
    make_residual(alignment, basis);
    alignment.solve(basis.product.view());
    subtract_scaled(basis.product.view(),
                    padded(std::vector<double>(basis.values.size(), 1.0), basis.product.cols()),
                    basis.unknowns.view(), alignment.machine());
    std::swap(basis.x, basis.before);
    alignment.prolong(basis.unknowns.view(), basis.x.view());
}

/// panel := panel * factor for both forms.
void multiply(const Alignment& alignment, const Matrix& factor, Basis& basis) {
    multiply_columns(basis.unknowns.view(), factor, alignment.machine());
    multiply_columns(basis.x.view(), factor, alignment.machine());
}

/// The upper triangular T that makes columns with these inner products orthonormal; those that are
/// nearly parallel come nearer to it only.
Matrix orthonormalizing(const Matrix& products, std::int64_t count) {
    // Floors the share of a column that is not in the span of those before it.
    constexpr double smallest_share = 1e-14;
    Matrix t(products.rows(), products.cols());
    for (std::int64_t j = 0; j < count; ++j) {
        const double size = std::sqrt(products(j, j));
        if (!(size > 0) || !std::isfinite(size))
            fail(Status::degenerate, "the frames do not vary enough for {} coordinates", count);
        t(j, j) = 1 / size;
        double share = 1;
        for (std::int64_t i = 0; i < j; ++i) {
            double overlap = 0; // of column i of the result with column j scaled to norm 1
            for (std::int64_t p = 0; p <= i; ++p)
                overlap += t(p, i) * products(p, j) / size;
            for (std::int64_t p = 0; p <= i; ++p)
                t(p, j) -= overlap * t(p, i);
            share -= overlap * overlap;
        }
        const double norm = std::sqrt(std::max(share, smallest_share));
        for (std::int64_t p = 0; p <= j; ++p)
            t(p, j) /= norm;
    }
    return t;
}

/// Makes the columns of basis.x orthonormal: repeated until they were, but for rounding, before.
void orthonormalize(const Alignment& alignment, Basis& basis) {
    constexpr int most_passes = 6;
    for (int pass = 0; pass < most_passes; ++pass) {
        const Matrix products = inner_products(basis.x.view(), basis.x.view(), alignment.machine());
        double worst = 0;
        for (std::int64_t i = 0; i < basis.count; ++i)
            for (std::int64_t j = 0; j < basis.count; ++j)
                worst = std::max(worst, std::abs(products(i, j) - (i == j ? 1.0 : 0.0)));
        multiply(alignment, orthonormalizing(products, basis.count), basis);
        if (worst < 1e-8) // what is left is of the order of its square
            return;
    }
}

/// The sine of the largest principal angle from the span of `after`'s first `count` columns to that
/// of `before`'s (both orthonormal): the largest singular value of what projection leaves.
double largest_angle(const Matrix& before, const Matrix& after, std::int64_t count,
                     const Machine& machine) {
    const auto first_rows = [count](Matrix products) {
        std::fill(products.row(count), products.row(products.rows()), 0.0);
        return products;
    };
    Matrix overlaps = first_rows(inner_products(before.view(), after.view(), machine));
    // What rounding left of the overlaps in the rest goes as well.
    const Matrix left =
        first_rows(rest_products(before.view(), overlaps, after.view(), machine).left);
    for (std::int64_t i = 0; i < count; ++i)
        for (std::int64_t j = 0; j < overlaps.cols(); ++j)
            overlaps(i, j) += left(i, j);
    const Matrix products = rest_products(before.view(), overlaps, after.view(), machine).rest;
    Matrix gram(count, count);
    for (std::int64_t i = 0; i < count; ++i)
        std::copy_n(products.row(i), count, gram.row(i));
    std::vector<double> values;
    symmetric_eigen(gram, values);
    return std::sqrt(std::max(0.0, values.back()));
}

/// Largest ||B u - lambda u|| / k over the first `count` vectors.
double largest_residual(const Alignment& alignment, Basis& basis, std::int64_t count) {
    make_residual(alignment, basis);
    Matrix& at_frames = basis.before;
    alignment.at_frames(basis.product.view(), at_frames.view());
    const Matrix squares = inner_products(at_frames.view(), at_frames.view(), alignment.machine());
    double largest = 0;
    for (std::int64_t j = 0; j < count; ++j)
        largest = std::max(largest, squares(j, j));
    return std::sqrt(largest) / static_cast<double>(alignment.patches().size());
}

/// Turns the basis into the best eigenvectors in its span.
void rayleigh_ritz(const Alignment& alignment, Basis& basis) {
    orthonormalize(alignment, basis);
    const Matrix form = alignment.apply(basis.unknowns.view(), basis.product.view(), basis.count);
    Matrix vectors(basis.count, basis.count);
    for (std::int64_t i = 0; i < basis.count; ++i)
        std::copy_n(form.row(i), basis.count, vectors.row(i));
    symmetric_eigen(vectors, basis.values); // one per row
    for (double& value : basis.values)
        value = std::max(value, 0.0); // B is positive semidefinite; a zero may round below
    Matrix rotation(basis.x.cols(), basis.x.cols());
    for (std::int64_t i = 0; i < basis.count; ++i)
        for (std::int64_t j = 0; j < basis.count; ++j)
            rotation(i, j) = vectors(j, i);
    multiply(alignment, rotation, basis);
    multiply_columns(basis.product.view(), rotation, alignment.machine());
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

/// A correction that turns the embedding by less than this is the last one: in differences the
/// first, which is a certificate; grounded, two or three are needed.
constexpr double small_change = 1e-12;
constexpr int most_corrections = 6;

} // namespace

Spectrum smallest_eigenpairs(const Alignment& alignment, std::int64_t count, std::int64_t dimension,
                             const Progress& progress) {
    const std::int64_t n = alignment.frames();
    const std::int64_t pairs = std::min(count, n - 1);
    const Machine& machine = alignment.machine();
    Eigenpairs found = largest_eigenpairs(pseudo_inverse(alignment), n, set_start, pairs, machine,
                                          [&] { progress.report(Stage::spectrum, 0.0); });
    Spectrum spectrum;
    spectrum.solves = found.applications;
    Basis basis = solved(alignment, std::exchange(found.vectors, {}));
    rayleigh_ritz(alignment, basis);
    double before = 2;
    for (int i = 0; i < most_corrections; ++i) {
        progress.report(Stage::spectrum, 0.5);
        correct(alignment, basis);
        rayleigh_ritz(alignment, basis);
        const double change = largest_angle(basis.before, basis.x, dimension, machine);
        if (i == 0)
            spectrum.first_change = change;
        spectrum.last_change = change;
        if (change < small_change || change > before / 2)
            break;
        before = change;
    }
    spectrum.residual = largest_residual(alignment, basis, dimension);
    spectrum.values = basis.values;
    spectrum.values.resize(static_cast<std::size_t>(std::min(count, pairs)));
    spectrum.vectors = rows_of(basis.x, dimension, machine);
    progress.report(Stage::spectrum, 1.0);
    return spectrum;
}

} // namespace stltsa::ltsa
