// SPDX-License-Identifier: BSD-3-Clause
#include "motion/curve/smoothing.hpp"

#include <algorithm>

#include "linalg/gaussian.hpp"

namespace stltsa::motion {
Matrix smooth(ConstMatrixView samples, double sigma) {
    return gaussian_smoothed(samples, sigma, Beyond::nothing, 1);
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
