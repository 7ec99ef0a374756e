// SPDX-License-Identifier: BSD-3-Clause
#include "motion/smoothing.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"

namespace stltsa::motion {
namespace {

/// Half of a symmetric kernel, its middle first, cut at four sigma; just 1 without smoothing.
std::vector<double> gaussian(double sigma) {
    std::vector<double> weights{1};
    for (int i = 1; i <= 4 * sigma; ++i)
        weights.push_back(std::exp(-0.5 * (i / sigma) * (i / sigma)));
    return weights;
}

} // namespace

Matrix smooth(ConstMatrixView samples, double sigma) {
    const std::vector<double> weights = gaussian(sigma);
    const auto reach = static_cast<std::int64_t>(weights.size()) - 1;
    Matrix result(samples.rows, samples.cols);
    for (std::int64_t i = 0; i < samples.rows; ++i) {
        const std::int64_t begin = std::max<std::int64_t>(0, i - reach);
        const std::int64_t end = std::min(samples.rows, i + reach + 1);
        double total = 0;
        for (std::int64_t r = begin; r < end; ++r)
            total += weights[static_cast<std::size_t>(std::abs(r - i))];
        for (std::int64_t r = begin; r < end; ++r)
            axpy(weights[static_cast<std::size_t>(std::abs(r - i))] / total, samples.row(r),
                 result.row(i), samples.cols);
    }
    return result;
}

std::vector<double> smooth(std::span<const double> curve, double sigma) {
    const auto rows = static_cast<std::int64_t>(curve.size());
    const Matrix result = smooth(ConstMatrixView{curve.data(), rows, 1, 1}, sigma);
    return {result.data(), result.data() + rows};
}

std::vector<double> slope(std::span<const double> curve) {
    std::vector<double> result(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1;
        const std::size_t after = std::min(i + 1, curve.size() - 1);
        if (after > before)
            result[i] = (curve[after] - curve[before]) / static_cast<double>(after - before);
    }
    return result;
}

} // namespace stltsa::motion
