// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/envelope.hpp"

#include "linalg/panel.hpp"
#include "linalg/simd.hpp"

namespace stltsa {

EnvelopeMatrix::EnvelopeMatrix(std::vector<std::int64_t> reach) : reach_(std::move(reach)) {
    offset_.reserve(reach_.size());
    std::int64_t total = 0;
    for (std::size_t j = 0; j < reach_.size(); ++j) {
        offset_.push_back(total);
        total += reach_[j] - static_cast<std::int64_t>(j) + 1;
    }
    entries_.resize(checked_size(total, 1));
}

namespace {

/// to -= factor * from
template <int W>
STLTSA_INLINE void subtract_multiple(double factor, const double* from, double* to,
                                     std::int64_t count) {
    std::int64_t i = 0;
    for (; i + W <= count; i += W)
        store(load<Pack<W>>(to + i) - factor * load<Pack<W>>(from + i), to + i);
    for (; i < count; ++i)
        to[i] -= factor * from[i];
}

/// Factors column after column, and takes each one's outer product from those that it reaches.
struct Factoring {
    EnvelopeMatrix& matrix;
    double smallest;
    const std::vector<double>& diagonal;
    bool& regular;

    template <int W>
    STLTSA_INLINE void run() const {
        regular = true;
        for (std::int64_t j = 0; j < matrix.order() && regular; ++j) {
            double* column = matrix.column(j);
            regular = column[0] > smallest * diagonal[static_cast<std::size_t>(j)];
            const double pivot = __builtin_sqrt(column[0]);
            const std::int64_t length = matrix.reach(j) - j;
            for (std::int64_t r = 1; r <= length; ++r)
                column[r] /= pivot;
            for (std::int64_t r = 1; r <= length; ++r)
                subtract_multiple<W>(column[r], column + r, matrix.column(j + r), length - r + 1);
            column[0] = 1 / pivot; // solves wait for it: a product is sooner there than a quotient
        }
    }
};

} // namespace

bool cholesky(EnvelopeMatrix& matrix, double smallest, Simd simd) {
    std::vector<double> diagonal(static_cast<std::size_t>(matrix.order()));
    for (std::int64_t j = 0; j < matrix.order(); ++j)
        diagonal[static_cast<std::size_t>(j)] = matrix.column(j)[0];
    bool regular = false;
    run_simd(simd, Factoring{matrix, smallest, diagonal, regular});
    return regular;
}

namespace {

/// Columns up to here are too short for vector code: what one step stores the next one loads again
/// at another place, and the machine waits for the store.
constexpr std::int64_t short_column = 32;

/// Row by row, so that a step waits for the last value before it alone, and stores one number.
void forward_by_rows(const EnvelopeMatrix& factor, double* values) {
    std::int64_t first = 0; // column that reaches row j
    for (std::int64_t j = 0; j < factor.order(); ++j) {
        while (factor.reach(first) < j)
            ++first;
        double value = values[j];
        for (std::int64_t c = first; c < j; ++c)
            value -= factor.column(c)[j - c] * values[c];
        values[j] = value * factor.column(j)[0];
    }
}

void forward_by_columns(const EnvelopeMatrix& factor, double* values) {
    for (std::int64_t j = 0; j < factor.order(); ++j) {
        const double* column = factor.column(j);
        values[j] *= column[0];
        axpy(-values[j], column + 1, values + j + 1, factor.reach(j) - j);
    }
}

void solve_vector(const EnvelopeMatrix& factor, double* values) {
    const bool brief = factor.entries() < short_column * factor.order();
    if (brief)
        forward_by_rows(factor, values);
    else
        forward_by_columns(factor, values);
    for (std::int64_t j = factor.order() - 1; j >= 0; --j) {
        const double* column = factor.column(j);
        const std::int64_t length = factor.reach(j) - j;
        double value = values[j];
        if (brief)
            for (std::int64_t r = length; r > 0; --r) // the newest value last
                value -= column[r] * values[j + r];
        else
            value -= dot(column + 1, values + j + 1, length);
        values[j] = value * column[0];
    }
}

struct PanelSolve {
    const EnvelopeMatrix& factor;
    MatrixView x;

    template <int W>
    STLTSA_INLINE void run() const {
        using P = Pack<W>;
        for (std::int64_t c = 0; c < x.cols; c += W) {
            for (std::int64_t j = 0; j < x.rows; ++j) {
                const double* column = factor.column(j);
                const P value = pack_at<P>(x.row(j) + c) * column[0];
                pack_at<P>(x.row(j) + c) = value;
                for (std::int64_t r = 1; r <= factor.reach(j) - j; ++r)
                    pack_at<P>(x.row(j + r) + c) -= column[r] * value;
            }
            for (std::int64_t j = x.rows - 1; j >= 0; --j) {
                const double* column = factor.column(j);
                P value = pack_at<P>(x.row(j) + c);
                for (std::int64_t r = factor.reach(j) - j; r > 0; --r)
                    value -= column[r] * pack_at<P>(x.row(j + r) + c);
                pack_at<P>(x.row(j) + c) = value * column[0];
            }
        }
    }
};

} // namespace

void cholesky_solve(const EnvelopeMatrix& factor, MatrixView x, Simd simd) {
    if (x.cols == 1)
        solve_vector(factor, x.data);
    else
        run_simd(panel_simd(x.cols, simd), PanelSolve{factor, x});
}

} // namespace stltsa
