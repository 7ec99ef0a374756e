// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/gram_batch.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"

namespace stltsa::ltsa {
namespace {

/// Columns of the block beyond those that are wanted, and iterations from one Rayleigh-Ritz step to
/// the next: what takes least time for windows of 12 to 48 frames of recorded motion.
constexpr std::int64_t guard_columns = 2;
constexpr std::int64_t ritz_interval = 5;

/// The correlation matrix from squared distances, and its eigenvectors from a start that is the
/// same in every lane: polynomials of the frames' order, which the directions of a short piece of
/// motion nearly are.
struct CorrelationKernel {
    BlockIteration iteration;

    template <int W>
    STLTSA_INLINE void run() const {
        using P = Pack<W>;
        center<P>();
        iteration.iterate<P>();
    }

    /// -1/2 J D J with J = I - e e^T / k
    template <class P>
    STLTSA_INLINE void center() const {
        P* matrix = reinterpret_cast<P*>(iteration.matrix_data);
        P* mean = reinterpret_cast<P*>(iteration.product_data);
        const std::int64_t size = iteration.size;
        const std::int64_t rows = iteration.rows;
        const double k = static_cast<double>(size);
        std::fill_n(mean, size, P{});
        for (std::int64_t a = 0; a < size; ++a) {
            matrix[a * rows + a] = P{};
            for (std::int64_t b = a + 1; b < size; ++b) {
                mean[a] += matrix[a * rows + b];
                mean[b] += matrix[a * rows + b];
            }
        }
        P total{};
        for (std::int64_t a = 0; a < size; ++a) {
            mean[a] /= k;
            total += mean[a];
        }
        total /= k;
        for (std::int64_t a = 0; a < size; ++a) {
            const P shift = total - mean[a];
            for (std::int64_t b = a; b < size; ++b)
                matrix[a * rows + b] = matrix[b * rows + a] =
                    -0.5 * (matrix[a * rows + b] - mean[b] + shift);
        }
    }
};

} // namespace

GramBatch::GramBatch(std::int64_t size, std::int64_t count, Simd simd)
    : size_(size), count_(count),
      eigen_({size, count, count + guard_columns, false, ritz_interval}, simd) {
    fill_start();
}

/// Orthonormal polynomials of degree 1, 2, .. on 0 .. size-1; zeros where there are no more.
void GramBatch::fill_start() {
    const double middle = 0.5 * static_cast<double>(size_ - 1);
    const std::int64_t degrees = std::min(eigen_.columns(), size_ - 1);
    AlignedVector<double> before(static_cast<std::size_t>(size_),
                                 1 / std::sqrt(static_cast<double>(size_)));
    const double* lower = before.data();
    for (std::int64_t l = 0; l < degrees; ++l) {
        double* column = eigen_.start(l);
        for (std::int64_t a = 0; a < size_; ++a)
            column[a] = lower[a] * (static_cast<double>(a) - middle) / (middle + 1);
        for (int pass = 0; pass < 2; ++pass) {
            axpy(-dot(before.data(), column, size_), before.data(), column, size_);
            for (std::int64_t b = 0; b < l; ++b)
                axpy(-dot(eigen_.start(b), column, size_), eigen_.start(b), column, size_);
        }
        const double norm = std::sqrt(dot(column, column, size_));
        for (std::int64_t a = 0; a < size_; ++a)
            column[a] /= norm;
        lower = column;
    }
}

void GramBatch::solve() {
    run_simd(eigen_.simd(), CorrelationKernel{eigen_.iteration()});
}

void GramBatch::directions(std::int64_t lane, std::span<const std::int32_t>, double* out) const {
    for (std::int64_t l = 0; l < count_; ++l)
        for (std::int64_t a = 0; a < size_; ++a)
            *out++ = eigen_.vector(lane, l, a);
}

} // namespace stltsa::ltsa
