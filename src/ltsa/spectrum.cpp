// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "linalg/arpack.hpp"
#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"

namespace stltsa::ltsa {
namespace {

using Vector = AlignedVector<double>;

std::span<double> row_span(Matrix& m, std::int64_t r) {
    return {m.row(r), static_cast<std::size_t>(m.cols())};
}
std::span<const double> row_span(const Matrix& m, std::int64_t r) {
    return {m.row(r), static_cast<std::size_t>(m.cols())};
}

/// x -> B^+ x: the wanted eigenpairs are its largest, so no shift is needed.
Operator pseudo_inverse(const Alignment& alignment) {
    return [&alignment, centered = Vector(static_cast<std::size_t>(alignment.frames())),
            unknowns = Vector(static_cast<std::size_t>(alignment.unknowns()))](
               std::span<const double> x, std::span<double> y) mutable {
        std::copy(x.begin(), x.end(), centered.begin());
        center(centered);
        alignment.restrict_to(centered, unknowns);
        alignment.solve(unknowns);
        alignment.prolong(unknowns, y);
    };
}

/// ARPACK always gets this start vector: its own are different on every call.
Vector start_vector(std::int64_t order) {
    Vector start(static_cast<std::size_t>(order));
    Random random(1);
    for (double& value : start)
        value = random.symmetric();
    center(start);
    return start;
}

/// A basis in both forms: row j of x is the prolongation of row j of unknowns.
struct Basis {
    Matrix unknowns;
    Matrix x;
};

/// Row j: (B')^-1 u_j. The unknowns of a vector come from a solve, because differences of its
/// entries would lose as many digits as the entries are larger than their differences.
Basis solved(const Alignment& alignment, const Matrix& vectors) {
    Basis basis{Matrix(vectors.rows(), alignment.unknowns()),
                Matrix(vectors.rows(), alignment.frames())};
    for (std::int64_t j = 0; j < vectors.rows(); ++j) {
        const auto unknowns = row_span(basis.unknowns, j);
        alignment.restrict_to(row_span(vectors, j), unknowns);
        alignment.solve(unknowns);
        alignment.prolong(unknowns, row_span(basis.x, j));
    }
    return basis;
}

/// One inverse iteration as a correction: z - F^-1 (B' z - lambda S^T x). With F = B' this is
/// lambda B'^-1 S^T x; in floating point the residual goes through the patches, so neither the
/// rounding of B' and its factor F nor a shift in F limits what the iteration converges to.
void correct(const Alignment& alignment, const std::vector<double>& values, Basis& basis) {
    Vector residual(static_cast<std::size_t>(alignment.unknowns()));
    Vector right(residual.size());
    for (std::int64_t j = 0; j < basis.x.rows(); ++j) {
        alignment.apply(row_span(basis.unknowns, j), residual);
        alignment.restrict_to(row_span(basis.x, j), right);
        axpy(-values[static_cast<std::size_t>(j)], right.data(), residual.data(),
             alignment.unknowns());
        alignment.solve(residual);
        axpy(-1, residual.data(), basis.unknowns.row(j), alignment.unknowns());
        alignment.prolong(row_span(basis.unknowns, j), row_span(basis.x, j));
    }
}

/// Makes the rows of basis.x orthonormal; twice, for those that were nearly parallel.
void orthonormalize(Basis& basis) {
    const std::int64_t n = basis.x.cols();
    const std::int64_t m = basis.unknowns.cols();
    const auto scale = [&](std::int64_t j) {
        const double norm = std::sqrt(dot(basis.x.row(j), basis.x.row(j), n));
        if (!(norm > 0) || !std::isfinite(norm))
            fail(Status::degenerate, "the frames do not vary enough for {} coordinates",
                 basis.x.rows());
        for (std::int64_t c = 0; c < n; ++c)
            basis.x(j, c) /= norm;
        for (std::int64_t c = 0; c < m; ++c)
            basis.unknowns(j, c) /= norm;
    };
    for (std::int64_t j = 0; j < basis.x.rows(); ++j) {
        scale(j);
        for (int pass = 0; pass < 2; ++pass)
            for (std::int64_t i = 0; i < j; ++i) {
                const double overlap = dot(basis.x.row(i), basis.x.row(j), n);
                axpy(-overlap, basis.x.row(i), basis.x.row(j), n);
                axpy(-overlap, basis.unknowns.row(i), basis.unknowns.row(j), m);
            }
        scale(j);
    }
}

/// Values of all basis vectors at one patch's frames, projected: rows of k entries.
void project_basis(const Alignment& alignment, std::int64_t patch, const Matrix& unknowns,
                   Matrix& values) {
    for (std::int64_t j = 0; j < unknowns.rows(); ++j) {
        alignment.gather(patch, row_span(unknowns, j), values.row(j));
        alignment.patches().project(patch, values.row(j));
    }
}

/// x_i^T B x_j as sums over patches of squares, so that small eigenvalues keep their digits.
Matrix quadratic_form(const Alignment& alignment, const Matrix& unknowns) {
    const std::int64_t k = alignment.patches().size();
    const std::int64_t count = unknowns.rows();
    Matrix form(count, count);
    Matrix values(count, k);
    for (std::int64_t p = 0; p < alignment.patches().count(); ++p) {
        project_basis(alignment, p, unknowns, values);
        for (std::int64_t i = 0; i < count; ++i)
            for (std::int64_t j = 0; j <= i; ++j)
                form(i, j) += dot(values.row(i), values.row(j), k);
    }
    for (std::int64_t i = 0; i < count; ++i)
        for (std::int64_t j = 0; j < i; ++j)
            form(j, i) = form(i, j);
    return form;
}

/// rows := rotation * rows
void rotate_rows(const Matrix& rotation, Matrix& rows) {
    Matrix rotated(rows.rows(), rows.cols());
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        for (std::int64_t j = 0; j < rows.rows(); ++j)
            axpy(rotation(i, j), rows.row(j), rotated.row(i), rows.cols());
    rows = std::move(rotated);
}

/// Sine of the largest principal angle from the span of `after`'s first `count` rows to that of
/// `before`'s (both orthonormal): the largest singular value of what projection leaves.
double largest_angle(const Matrix& before, const Matrix& after, std::int64_t count) {
    Matrix rest(count, before.cols());
    for (std::int64_t i = 0; i < count; ++i) {
        std::copy_n(after.row(i), after.cols(), rest.row(i));
        for (int pass = 0; pass < 2; ++pass)
            for (std::int64_t j = 0; j < count; ++j)
                axpy(-dot(before.row(j), rest.row(i), rest.cols()), before.row(j), rest.row(i),
                     rest.cols());
    }
    Matrix gram(count, count);
    for (std::int64_t i = 0; i < count; ++i)
        for (std::int64_t j = 0; j < count; ++j)
            gram(i, j) = dot(rest.row(i), rest.row(j), rest.cols());
    std::vector<double> values;
    symmetric_eigen(gram, values);
    return std::sqrt(std::max(0.0, values.back()));
}

/// ||B u - lambda u|| / k with B u through the patches.
double residual_of(const Alignment& alignment, std::span<const double> unknowns,
                   std::span<const double> x, double lambda) {
    const Patches& patches = alignment.patches();
    Vector product(x.size());
    Vector values(static_cast<std::size_t>(patches.size()));
    for (std::int64_t p = 0; p < patches.count(); ++p) {
        alignment.gather(p, unknowns, values.data());
        patches.project(p, values.data());
        const auto frames = patches.of(p);
        for (std::size_t j = 0; j < frames.size(); ++j)
            product[static_cast<std::size_t>(frames[j])] += values[j];
    }
    axpy(-lambda, x.data(), product.data(), static_cast<std::int64_t>(x.size()));
    const auto n = static_cast<std::int64_t>(product.size());
    return std::sqrt(dot(product.data(), product.data(), n)) / static_cast<double>(patches.size());
}

/// Turns the basis into the best eigenvectors in its span; eigenvalues ascending.
std::vector<double> rayleigh_ritz(const Alignment& alignment, Basis& basis) {
    orthonormalize(basis);
    Matrix rotation = quadratic_form(alignment, basis.unknowns);
    std::vector<double> values;
    symmetric_eigen(rotation, values);
    for (double& value : values)
        value = std::max(value, 0.0); // B is positive semidefinite; a zero may round below
    rotate_rows(rotation, basis.unknowns);
    rotate_rows(rotation, basis.x);
    return values;
}

/// Beyond the wanted pairs: their eigenvectors guard the wanted ones during correction.
constexpr std::int64_t guard_pairs = 2;
/// A correction that turns the embedding by less than this is the last one: in differences the
/// first, which is a certificate; grounded, two or three are needed.
constexpr double small_change = 1e-10;
constexpr int most_corrections = 6;

} // namespace

Spectrum smallest_eigenpairs(const Alignment& alignment, std::int64_t count, std::int64_t dimension,
                             const Progress& progress) {
    const std::int64_t n = alignment.frames();
    const std::int64_t pairs = std::min(count + guard_pairs, n - 1);
    const Eigenpairs found = largest_eigenpairs(pseudo_inverse(alignment), start_vector(n), pairs,
                                                [&] { progress.report(Stage::spectrum, 0.0); });
    Spectrum spectrum;
    spectrum.solves = found.applications;
    Basis basis = solved(alignment, found.vectors);
    spectrum.values = rayleigh_ritz(alignment, basis);
    double before = 2;
    for (int i = 0; i < most_corrections; ++i) {
        progress.report(Stage::spectrum, 0.5);
        const Matrix previous = basis.x;
        correct(alignment, spectrum.values, basis);
        spectrum.values = rayleigh_ritz(alignment, basis);
        const double change = largest_angle(previous, basis.x, dimension);
        if (i == 0)
            spectrum.first_change = change;
        spectrum.last_change = change;
        if (change < small_change || change > before / 2)
            break;
        before = change;
    }
    for (std::int64_t j = 0; j < dimension; ++j)
        spectrum.residual =
            std::max(spectrum.residual,
                     residual_of(alignment, row_span(basis.unknowns, j), row_span(basis.x, j),
                                 spectrum.values[static_cast<std::size_t>(j)]));
    spectrum.values.resize(static_cast<std::size_t>(std::min(count, pairs)));
    spectrum.vectors = std::move(basis.x);
    progress.report(Stage::spectrum, 1.0);
    return spectrum;
}

} // namespace stltsa::ltsa
