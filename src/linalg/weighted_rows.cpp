// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/weighted_rows.hpp"

#include "linalg/pack.hpp"

namespace stltsa {
namespace {

/// With `centered`, of the rows minus a center.
template <bool centered>
struct WeightedRows {
    ConstMatrixView rows;
    const double* weights;
    std::int64_t step;
    const double* center;
    double* out;

    template <int W>
    STLTSA_INLINE void run() const {
        constexpr std::int64_t at_once = std::int64_t{4} * W;
        std::int64_t c = 0;
        for (; c + at_once <= rows.cols; c += at_once)
            add<Pack<W>, at_once, 4>(c);
        for (; c + W <= rows.cols; c += W)
            add<Pack<W>, W, 1>(c);
        for (; c < rows.cols; ++c)
            add<double, 1, 1>(c);
    }

  private:
    /// The columns from c on: `count` packs, `width` columns in all.
    template <class P, std::int64_t width, std::int64_t count>
    STLTSA_INLINE void add(std::int64_t c) const {
        constexpr std::int64_t each = width / count;
        P sum[count];
        [[maybe_unused]] P middle[count];
        for (std::int64_t k = 0; k < count; ++k) {
            sum[k] = load<P>(out + c + k * each);
            if constexpr (centered)
                middle[k] = load<P>(center + c + k * each);
        }
        for (std::int64_t r = 0; r < rows.rows; ++r) {
            const double weight = weights[r * step];
            const double* row = rows.row(r) + c;
            for (std::int64_t k = 0; k < count; ++k)
                if constexpr (centered)
                    sum[k] += weight * (load<P>(row + k * each) - middle[k]);
                else
                    sum[k] += weight * load<P>(row + k * each);
        }
        for (std::int64_t k = 0; k < count; ++k)
            store(sum[k], out + c + k * each);
    }
};

} // namespace

void add_weighted(ConstMatrixView rows, const double* weights, std::int64_t step, double* out) {
    run_simd(widest_simd(), WeightedRows<false>{rows, weights, step, nullptr, out});
}

void add_weighted_differences(ConstMatrixView rows, const double* center, const double* weights,
                              double* out) {
    run_simd(widest_simd(), WeightedRows<true>{rows, weights, 1, center, out});
}

} // namespace stltsa
