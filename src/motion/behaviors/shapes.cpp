// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/checkpoint.hpp"
#include "base/random.hpp"
#include "linalg/gaussian.hpp"
#include "linalg/principal.hpp"
#include "linalg/simd.hpp"
#include "motion/behaviors/poses.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

constexpr int convolutions = 120;
constexpr std::int64_t length = 9; ///< of each
constexpr double pooled_periods = 1.5;
/// Of the features, these principal directions are kept.
constexpr std::int64_t most_directions = 12;
/// The usual period: the first peak of the autocorrelation that is nearly as high as the highest.
constexpr double nearly_as_high = 0.8;
constexpr std::int64_t shortest_period = 8;
constexpr std::int64_t longest_period = 2000;
/// The longest period fits into the recording this often.
constexpr std::int64_t periods_at_least = 16;
/// A quantile is taken of at most this many values.
constexpr std::int64_t most_sampled = 5000;

/// In [0, 1).
double share(Random& random) {
    return (1 + random.symmetric()) / 2;
}

/// Mean products of rows that are `lag` apart, for each lag below `count`.
std::vector<double> autocorrelation(const Matrix& x, std::int64_t count) {
    std::vector<double> values;
    for (std::int64_t lag = 0; lag < count; ++lag) {
        const std::int64_t products = x.rows() - lag;
        checkpoint(products * x.cols());
        values.push_back(dot(x.data(), x.data() + lag * x.cols(), products * x.cols()) /
                         static_cast<double>(products));
    }
    return values;
}

std::int64_t usual_period(ConstMatrixView poses) {
    const std::int64_t most = std::min(longest_period, poses.rows / periods_at_least);
    Matrix moving = gaussian_smoothed(poses, static_cast<double>(most) / 4, Beyond::nothing, 1);
    for (std::int64_t i = 0; i < moving.rows(); ++i)
        for (std::int64_t c = 0; c < moving.cols(); ++c)
            moving(i, c) = poses(i, c) - moving(i, c);
    const std::vector<double> values = autocorrelation(moving, most);
    std::vector<std::size_t> peaks;
    double highest = 0;
    for (std::size_t lag = shortest_period; lag + 1 < values.size(); ++lag)
        if (values[lag] >= values[lag - 1] && values[lag] > values[lag + 1]) {
            peaks.push_back(lag);
            highest = std::max(highest, values[lag]);
        }
    for (const std::size_t peak : peaks)
        if (values[peak] >= nearly_as_high * highest && highest > 0)
            return static_cast<std::int64_t>(peak);
    return most / 4;
}

/// Each value less its local mean, divided by its local standard deviation.
Matrix standardized(ConstMatrixView poses, double sigma) {
    constexpr double rounding = 1e-6;
    const Matrix around = windowed(poses, sigma);
    const double least = rounding * std::sqrt(total_variance(poses));
    Matrix result(poses.rows, poses.cols);
    for (std::int64_t i = 0; i < poses.rows; ++i)
        for (std::int64_t c = 0; c < poses.cols; ++c)
            if (const double deviation = around(i, poses.cols + c); deviation > least)
                result(i, c) = (poses(i, c) - around(i, c)) / deviation;
    return result;
}

/// A random weighted sum of the columns.
std::vector<double> mixture(const Matrix& x, Random& random) {
    std::vector<double> weights;
    for (std::int64_t c = 0; c < x.cols(); ++c)
        weights.push_back(random.symmetric());
    std::vector<double> mixed;
    for (std::int64_t i = 0; i < x.rows(); ++i)
        mixed.push_back(dot(x.row(i), weights.data(), x.cols()));
    return mixed;
}

/// Convolves with random dilated weights of mean 0; beyond the ends, values count as 0.
std::vector<double> convolved(const std::vector<double>& x, std::int64_t period, Random& random) {
    const double widest =
        std::max(2.0, 2 * static_cast<double>(period) / static_cast<double>(length));
    const auto apart = static_cast<std::int64_t>(std::pow(widest, share(random)));
    std::vector<double> weights;
    double sum = 0;
    for (std::int64_t k = 0; k < length; ++k) {
        weights.push_back(random.symmetric());
        sum += weights.back();
    }
    const auto n = static_cast<std::int64_t>(x.size());
    std::vector<double> result(x.size());
    for (std::int64_t k = 0; k < length; ++k) {
        const std::int64_t shift = (k - length / 2) * apart;
        const std::int64_t first = std::max<std::int64_t>(0, -shift);
        const std::int64_t count = std::min(n, n - shift) - first;
        if (count > 0)
            axpy(weights[static_cast<std::size_t>(k)] - sum / static_cast<double>(length),
                 x.data() + first + shift, result.data() + first, count);
    }
    return result;
}

double sampled_quantile(const std::vector<double>& values, double share) {
    const std::size_t step = values.size() / most_sampled + 1;
    std::vector<double> some;
    for (std::size_t i = 0; i < values.size(); i += step)
        some.push_back(values[i]);
    return quantile(some, share);
}

/// The centered rows along their principal directions.
Matrix reduced(Matrix rows) {
    const std::vector<double> mean = column_means(rows.view());
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        axpy(-1, mean.data(), rows.row(i), rows.cols());
    const PrincipalDirections principal = principal_directions(rows.view(), most_directions);
    Matrix result(rows.rows(), principal.directions.rows());
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        for (std::int64_t d = 0; d < result.cols(); ++d)
            result(i, d) = dot(rows.row(i), principal.directions.row(d), rows.cols());
    return result;
}

} // namespace

Shapes make_shapes(ConstMatrixView poses) {
    Shapes shapes;
    if (poses.cols == 0 || poses.rows < periods_at_least * shortest_period)
        return shapes;
    const std::int64_t period = usual_period(poses);
    shapes.step = std::max<std::int64_t>(1, period / moments_of_period);
    const Matrix x = standardized(poses, static_cast<double>(period));
    Random random(1);
    Matrix above((x.rows() + shapes.step - 1) / shapes.step, convolutions);
    for (int i = 0; i < convolutions; ++i) {
        const std::vector<double> y = convolved(mixture(x, random), period, random);
        const double limit = sampled_quantile(y, 0.2 + 0.6 * share(random));
        for (std::int64_t k = 0; k < above.rows(); ++k) {
            const auto first = y.begin() + k * shapes.step;
            const auto end = k + 1 < above.rows() ? first + shapes.step : y.end();
            const auto count = std::count_if(first, end, [&](double v) { return v > limit; });
            above(k, i) = static_cast<double>(count) / static_cast<double>(end - first);
        }
    }
    Matrix pooled =
        gaussian_smoothed(above.view(), pooled_periods * moments_of_period, Beyond::nothing, 1);
    shapes.rows = reduced(std::move(pooled));
    return shapes;
}

} // namespace stltsa::motion
