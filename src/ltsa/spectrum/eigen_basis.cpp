// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/spectrum/eigen_basis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linalg/eigen.hpp"

namespace stltsa::ltsa {
namespace {

/// The upper triangular T that makes columns with these inner products orthonormal, or, if they are
/// nearly parallel, closer to orthonormal.
Matrix orthonormalizing(const Matrix& products, std::int64_t count) {
    // Lower bound of the share of a column outside the span of the previous ones.
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

/// The largest cosine between two of the columns with these inner products.
double largest_cosine(const Matrix& products, std::int64_t count) {
    double largest = 0;
    for (std::int64_t i = 0; i < count; ++i)
        for (std::int64_t j = 0; j < i; ++j)
            largest = std::max(largest, std::abs(products(i, j)) / std::sqrt(products(i, i)) /
                                            std::sqrt(products(j, j)));
    return largest;
}

/// T^T form T for the first `count` columns.
Matrix congruent(const Matrix& form, const Matrix& t, std::int64_t count) {
    Matrix product(count, count), result(count, count); // form T, then T^T of it
    for (std::int64_t i = 0; i < count; ++i)
        for (std::int64_t p = 0; p < count; ++p)
            for (std::int64_t j = 0; j < count; ++j)
                product(i, j) += form(i, p) * t(p, j);
    for (std::int64_t p = 0; p < count; ++p)
        for (std::int64_t i = 0; i < count; ++i)
            for (std::int64_t j = 0; j < count; ++j)
                result(i, j) += t(p, i) * product(p, j);
    return result;
}

/// The values as one row, padded with zeros to the width of a panel.
Matrix padded(const std::vector<double>& values, std::int64_t width) {
    Matrix result(1, width);
    std::copy(values.begin(), values.end(), result.data());
    return result;
}

/// product := B' z - lambda S^T x of each vector, from B' z.
void make_residual(const Alignment& alignment, EigenBasis& basis) {
    alignment.restrict_to(basis.x.view(), basis.right.view());
    subtract_scaled(basis.right.view(), padded(basis.values, basis.right.cols()),
                    basis.product.view(), alignment.machine());
}

} // namespace

Matrix orthonormal_factor(const Alignment& alignment, EigenBasis& basis) {
    constexpr int most_passes = 6;
    constexpr double small_cosine = 0.1;
    for (int pass = 0;; ++pass) {
        const Matrix products = inner_products(basis.x.view(), basis.x.view(), alignment.machine());
        Matrix factor = orthonormalizing(products, basis.count);
        if (pass == most_passes || largest_cosine(products, basis.count) < small_cosine)
            return factor;
        multiply_columns(basis.unknowns.view(), factor, alignment.machine());
        multiply_columns(basis.x.view(), factor, alignment.machine());
    }
}

void rayleigh_ritz(const Alignment& alignment, EigenBasis& basis) {
    Matrix factor = orthonormal_factor(alignment, basis);
    const Matrix form = alignment.apply(basis.unknowns.view(), basis.product.view(), basis.count);
    Matrix vectors = congruent(form, factor, basis.count);
    symmetric_eigen(vectors, basis.values); // one per row
    for (double& value : basis.values)
        value = std::max(value, 0.0); // B is positive semidefinite; a zero may round below
    Matrix rotation(basis.x.cols(), basis.x.cols());
    for (std::int64_t i = 0; i < basis.count; ++i)
        for (std::int64_t j = 0; j < basis.count; ++j)
            rotation(i, j) = vectors(j, i);
    multiply_columns(factor.view(), rotation, {Simd::baseline, 1});
    for (Matrix* panel : {&basis.unknowns, &basis.x, &basis.product})
        multiply_columns(panel->view(), factor, alignment.machine());
}

void correct(const Alignment& alignment, EigenBasis& basis) {
    make_residual(alignment, basis);
    alignment.solve(basis.product.view(), basis.count);
    subtract_scaled(basis.product.view(),
                    padded(std::vector<double>(basis.values.size(), 1.0), basis.product.cols()),
                    basis.unknowns.view(), alignment.machine());
    std::swap(basis.x, basis.before);
    alignment.prolong(basis.unknowns.view(), basis.x.view());
}

// The largest singular value of the residual of x projected onto `before`; both are orthonormal.
double last_turn(const EigenBasis& basis, std::int64_t count, const Machine& machine) {
    const auto first_rows = [count](Matrix products) {
        std::fill(products.row(count), products.row(products.rows()), 0.0);
        return products;
    };
    Matrix overlaps = first_rows(inner_products(basis.before.view(), basis.x.view(), machine));
    // Adds the overlaps that rounding left in the residual.
    const Matrix left =
        first_rows(residual_products(basis.before.view(), overlaps, basis.x.view(), machine).left);
    for (std::int64_t i = 0; i < count; ++i)
        for (std::int64_t j = 0; j < overlaps.cols(); ++j)
            overlaps(i, j) += left(i, j);
    const Matrix products =
        residual_products(basis.before.view(), overlaps, basis.x.view(), machine).residual;
    Matrix gram(count, count);
    for (std::int64_t i = 0; i < count; ++i)
        std::copy_n(products.row(i), count, gram.row(i));
    std::vector<double> values;
    symmetric_eigen(gram, values);
    return std::sqrt(std::max(0.0, values.back()));
}

double largest_residual(const Alignment& alignment, EigenBasis& basis, std::int64_t count) {
    make_residual(alignment, basis);
    Matrix& at_frames = basis.before;
    alignment.at_frames(basis.product.view(), at_frames.view());
    const Matrix squares = inner_products(at_frames.view(), at_frames.view(), alignment.machine());
    double largest = 0;
    for (std::int64_t j = 0; j < count; ++j)
        largest = std::max(largest, squares(j, j));
    return std::sqrt(largest) / static_cast<double>(alignment.patches().size());
}

} // namespace stltsa::ltsa
