// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/panel.hpp"

#include <algorithm>

namespace stltsa {
namespace {

/// Rows that are summed on their own before they go into the whole, which loses fewer digits.
constexpr std::int64_t row_block = 1024;

struct InnerProducts {
    ConstMatrixView a, b;
    MatrixView out;

    template <int W>
    STLTSA_INLINE void run() const {
        for_columns<W>(b.cols, *this);
    }
    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        for (std::int64_t row = 0; row < a.rows; ++row) {
            const P right = pack_at<P>(b.row(row) + c);
            for (std::int64_t p = 0; p < a.cols; ++p)
                pack_at<P>(out.row(p) + c) += a(row, p) * right;
        }
    }
};

struct ColumnProduct {
    MatrixView panel;
    ConstMatrixView factor;
    double* row_before;

    template <int W>
    STLTSA_INLINE void run() const {
        for (std::int64_t row = 0; row < panel.rows; ++row) {
            std::copy_n(panel.row(row), panel.cols, row_before);
            for (std::int64_t c = 0; c < panel.cols; c += W) {
                Pack<W> sum{};
                for (std::int64_t p = 0; p < panel.cols; ++p)
                    sum += row_before[p] * pack_at<Pack<W>>(factor.row(p) + c);
                pack_at<Pack<W>>(panel.row(row) + c) = sum;
            }
        }
    }
};

struct Centering {
    MatrixView panel;

    template <int W>
    STLTSA_INLINE void run() const {
        for_columns<W>(panel.cols, *this);
    }
    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        P mean{};
        for (std::int64_t row = 0; row < panel.rows; ++row)
            mean += pack_at<P>(panel.row(row) + c);
        mean /= static_cast<double>(panel.rows);
        for (std::int64_t row = 0; row < panel.rows; ++row)
            pack_at<P>(panel.row(row) + c) -= mean;
    }
};

} // namespace

Matrix inner_products(ConstMatrixView a, ConstMatrixView b, Simd simd) {
    Matrix sum(a.cols, b.cols);
    for (std::int64_t first = 0; first < a.rows; first += row_block) {
        const std::int64_t rows = std::min(row_block, a.rows - first);
        Matrix part(a.cols, b.cols);
        run_simd(panel_simd(a.cols, simd),
                 InnerProducts{a.block(first, rows), b.block(first, rows), part.view()});
        for (std::int64_t i = 0; i < a.cols * b.cols; ++i)
            sum.data()[i] += part.data()[i];
    }
    return sum;
}

void multiply_columns(MatrixView panel, const Matrix& factor, Simd simd) {
    AlignedVector<double> row(static_cast<std::size_t>(panel.cols));
    run_simd(panel_simd(panel.cols, simd), ColumnProduct{panel, factor.view(), row.data()});
}

void subtract_scaled(ConstMatrixView source, const Matrix& factors, MatrixView target) {
    for (std::int64_t row = 0; row < source.rows; ++row)
        for (std::int64_t c = 0; c < source.cols; ++c)
            target(row, c) -= factors(0, c) * source(row, c);
}

void center(MatrixView panel, Simd simd) {
    run_simd(panel_simd(panel.cols, simd), Centering{panel});
}

} // namespace stltsa
