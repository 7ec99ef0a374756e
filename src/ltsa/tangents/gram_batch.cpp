// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangents/gram_batch.hpp"

#include <algorithm>

#include "linalg/simd.hpp"

namespace stltsa::ltsa {
namespace {

/// Additional columns of the block: the fastest choice for windows of 12 to 48 frames of recorded
/// motion.
constexpr std::int64_t correlation_guards = 2;

/// Computes the correlation matrix from squared distances, and its eigenvectors.
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
    : size_(size), count_(count), eigen_({size, count, count + correlation_guards}, simd) {}

void GramBatch::solve() {
    run_simd(eigen_.simd(), CorrelationKernel{eigen_.iteration()});
}

void GramBatch::directions(std::int64_t lane, std::span<const std::int32_t>, double* out) const {
    for (std::int64_t l = 0; l < count_; ++l)
        for (std::int64_t a = 0; a < size_; ++a)
            *out++ = eigen_.vector(lane, l, a);
}

} // namespace stltsa::ltsa
