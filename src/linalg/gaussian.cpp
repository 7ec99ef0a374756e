// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/gaussian.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/checkpoint.hpp"
#include "linalg/weighted_rows.hpp"

namespace stltsa {
namespace {

/// From one end to the other; only the weight 1 without smoothing.
std::vector<double> kernel(double sigma, std::int64_t rows) {
    const double reach = std::min(4 * sigma, static_cast<double>(rows - 1));
    const auto whole = std::max<std::int64_t>(0, static_cast<std::int64_t>(reach));
    std::vector<double> weights;
    for (std::int64_t i = -whole; i <= whole; ++i) {
        const double place = i == 0 ? 0 : static_cast<double>(i) / sigma;
        weights.push_back(std::exp(-0.5 * place * place));
    }
    return weights;
}

std::int64_t reach_of(const std::vector<double>& weights) {
    return static_cast<std::int64_t>(weights.size()) / 2;
}

/// Adds the weighted difference of row `r` from `center`, which lies beyond an end: a reflection
/// through the end row.
void add_reflected(ConstMatrixView rows, std::int64_t r, const double* center, double weight,
                   double* out) {
    const std::int64_t end = std::clamp<std::int64_t>(r, 0, rows.rows - 1);
    const double* at_end = rows.row(end);
    const double* reflected = rows.row(2 * end - r);
    for (std::int64_t c = 0; c < rows.cols; ++c)
        out[c] += weight * ((at_end[c] - reflected[c]) + (at_end[c] - center[c]));
}

/// The middle row plus the weighted differences from it: exact if there are none.
void smooth_row(ConstMatrixView rows, std::int64_t middle, const std::vector<double>& weights,
                Beyond beyond, double* out) {
    const bool reflect = beyond == Beyond::reflection;
    const std::int64_t begin = middle - reach_of(weights), end = middle + reach_of(weights) + 1;
    const std::int64_t first = std::max<std::int64_t>(0, begin), last = std::min(rows.rows, end);
    const auto weight = [&](std::int64_t r) {
        return weights[static_cast<std::size_t>(r - begin)];
    };
    const double* center = rows.row(middle);
    std::fill_n(out, rows.cols, 0.0);
    for (std::int64_t r = begin; reflect && r < first; ++r)
        add_reflected(rows, r, center, weight(r), out);
    add_weighted_differences(rows.block(first, last - first), center,
                             weights.data() + (first - begin), out);
    for (std::int64_t r = last; reflect && r < end; ++r)
        add_reflected(rows, r, center, weight(r), out);
    double total = 0;
    for (std::int64_t r = reflect ? begin : first; r < (reflect ? end : last); ++r)
        total += weight(r);
    for (std::int64_t c = 0; c < rows.cols; ++c)
        out[c] = center[c] + out[c] / total;
}

/// For checkpoint().
std::int64_t work_of_row(const std::vector<double>& weights, std::int64_t cols) {
    return static_cast<std::int64_t>(weights.size()) * cols;
}

/// Every `step`-th row.
void smooth_rows(ConstMatrixView rows, const std::vector<double>& weights, Beyond beyond,
                 std::int64_t step, MatrixView smoothed) {
    const std::int64_t work = work_of_row(weights, rows.cols);
    for (std::int64_t i = 0; i < smoothed.rows; ++i) {
        smooth_row(rows, i * step, weights, beyond, smoothed.row(i));
        checkpoint(work);
    }
}

} // namespace

void smooth_to(MatrixView smoothed, ConstMatrixView rows, double sigma, Beyond beyond) {
    smooth_rows(rows, kernel(sigma, rows.rows), beyond, 1, smoothed);
}

Matrix gaussian_smoothed(ConstMatrixView rows, double sigma, Beyond beyond, std::int64_t step) {
    const std::vector<double> weights = kernel(sigma, rows.rows);
    Matrix result = Matrix::unset((rows.rows + step - 1) / step, rows.cols);
    smooth_rows(rows, weights, beyond, step, result.view());
    return result;
}

void smooth_in_place(Matrix& rows, double sigma, Beyond beyond) {
    const std::vector<double> weights = kernel(sigma, rows.rows());
    const std::int64_t work = work_of_row(weights, rows.cols());
    const std::int64_t reach = reach_of(weights);
    const std::int64_t block = std::max<std::int64_t>(4096, reach);
    Matrix before; // the original rows that the next block needs
    for (std::int64_t begin = 0; begin < rows.rows(); begin += block) {
        const std::int64_t end = std::min(begin + block, rows.rows());
        const std::int64_t last = std::min(end + reach, rows.rows());
        const std::int64_t first = begin - before.rows();
        Matrix around = Matrix::unset(last - first, rows.cols());
        std::copy_n(before.data(), before.rows() * rows.cols(), around.data());
        std::copy_n(rows.row(begin), (last - begin) * rows.cols(), around.row(before.rows()));
        for (std::int64_t i = begin; i < end; ++i) {
            smooth_row(around.view(), i - first, weights, beyond, rows.row(i));
            checkpoint(work);
        }
        const std::int64_t kept = std::min(reach, end - first);
        before = copied(around.view().block(end - kept - first, kept));
    }
}

} // namespace stltsa
