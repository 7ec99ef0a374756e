// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangents/local_pca.hpp"

#include <algorithm>
#include <cmath>

#include <cblas.h>

#include "linalg/simd.hpp"
#include "ltsa/frames.hpp"
#include "ltsa/tangents/centered.hpp"

namespace stltsa::ltsa {

LocalPca::LocalPca(ConstMatrixView x, std::int64_t size, std::int64_t count, Simd simd)
    : x_(x), size_(size), eigen_(std::min(size, x.cols), count), distances_(x, size, simd) {
    if (frame_side()) {
        mean_.resize(static_cast<std::size_t>(size));
    } else {
        centered_ = Matrix(size, x.cols);
        mean_.resize(static_cast<std::size_t>(x.cols));
    }
}

void LocalPca::compute(std::span<const std::int32_t> neighborhood) {
    correlate(neighborhood);
    eigen_.solve();
}

void LocalPca::compute_values(std::span<const std::int32_t> neighborhood) {
    correlate(neighborhood);
    eigen_.solve_values();
}

void LocalPca::correlate(std::span<const std::int32_t> neighborhood) {
    // X^T X and X X^T have the same nonzero eigenvalues: use the smaller one.
    if (frame_side())
        gram(neighborhood);
    else
        covariance(neighborhood);
    const std::int64_t order = std::min(size_, x_.cols);
    double trace = 0;
    for (std::int64_t a = 0; a < order; ++a)
        trace += eigen_.matrix()[a * (order + 1)];
    if (!std::isfinite(trace)) // LAPACK does not accept NaN
        fail_changed(neighborhood.front());
}

/// The correlation matrix of Table 1, step 2 from squared distances: -1/2 J D J with
/// J = I - e e^T / k. Equal frames give exact zeros, and large means lose no digits.
void LocalPca::gram(std::span<const std::int32_t> neighborhood) {
    const auto among = distances_.among(neighborhood);
    const std::int64_t k = size_;
    double* matrix = eigen_.matrix();
    std::fill(mean_.begin(), mean_.end(), 0.0);
    for (std::int64_t a = 0; a < k; ++a) {
        matrix[a * k + a] = 0;
        for (std::int64_t b = a + 1; b < k; ++b) {
            const double d = among(a, b);
            matrix[a * k + b] = d;
            mean_[static_cast<std::size_t>(a)] += d;
            mean_[static_cast<std::size_t>(b)] += d;
        }
    }
    double total = 0;
    for (double& m : mean_) {
        m /= static_cast<double>(k);
        total += m;
    }
    total /= static_cast<double>(k);
    for (std::int64_t a = 0; a < k; ++a) {
        const double shift = total - mean_[static_cast<std::size_t>(a)];
        for (std::int64_t b = a; b < k; ++b)
            matrix[a * k + b] =
                -0.5 * (matrix[a * k + b] - mean_[static_cast<std::size_t>(b)] + shift);
    }
}

void LocalPca::covariance(std::span<const std::int32_t> neighborhood) {
    write_differences(x_, neighborhood, x_.row(neighborhood[neighborhood.size() / 2]),
                      centered_.data());
    mean_of(centered_.view(), mean_.data());
    subtract(mean_.data(), centered_.view());
    const auto m = static_cast<int>(x_.cols);
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, m, static_cast<int>(size_), 1.0,
                centered_.data(), m, 0.0, eigen_.matrix(), m);
}

void LocalPca::direction(std::int64_t l, double* out, const double* before) const {
    const double* vector = eigen_.vector(l);
    if (frame_side()) {
        std::copy_n(vector, size_, out);
    } else {
        for (std::int64_t a = 0; a < size_; ++a)
            out[a] = dot(centered_.row(a), vector, x_.cols);
    }
    make_tangent(before, l, size_, out);
}

void make_tangent(const double* before, std::int64_t count, std::int64_t size, double* direction) {
    const double mean = sum(direction, size) / static_cast<double>(size);
    for (std::int64_t a = 0; a < size; ++a)
        direction[a] -= mean;
    for (std::int64_t b = 0; b < count; ++b)
        axpy(-dot(before + b * size, direction, size), before + b * size, direction, size);
    const double norm = std::sqrt(dot(direction, direction, size));
    if (norm > 0)
        for (std::int64_t a = 0; a < size; ++a)
            direction[a] /= norm;
}

} // namespace stltsa::ltsa
