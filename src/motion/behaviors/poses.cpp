// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/poses.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linalg/gaussian.hpp"
#include "linalg/principal.hpp"
#include "linalg/simd.hpp"

namespace stltsa::motion {
namespace {

/// Each direction is divided by its standard deviation to this power.
constexpr double evened = 0.5;
constexpr std::int64_t most_directions = 16;
/// The directions contain this share of the variance; the others would be amplified noise.
constexpr double variance_share = 0.99;

/// Subtracts the mean of the columns, and divides them by the root of their total variance.
void standardize(Matrix& rows, std::int64_t first, std::int64_t count) {
    const MatrixView columns{rows.data() + first, rows.rows(), count, rows.cols()};
    const std::vector<double> mean = column_means(columns);
    const double variance = total_variance(columns);
    const double rounding =
        1e-20 * dot(mean.data(), mean.data(), static_cast<std::int64_t>(mean.size()));
    const double scale = variance > rounding ? 1 / std::sqrt(variance) : 0;
    for (std::int64_t i = 0; i < columns.rows; ++i)
        for (std::int64_t c = 0; c < count; ++c)
            columns.row(i)[c] = scale * (columns.row(i)[c] - mean[static_cast<std::size_t>(c)]);
}

} // namespace

Matrix even_poses(const Signal& signal, const Matrix& beside, std::int64_t step) {
    const std::int64_t n = (signal.rows() + step - 1) / step, p = signal.cols();
    Matrix all(n, p + beside.cols());
    for (std::int64_t i = 0; i < n; ++i) {
        std::copy_n(signal.poses.row(i * step), p, all.row(i));
        if (beside.cols() > 0)
            std::copy_n(beside.row(i * step * signal.step), beside.cols(), all.row(i) + p);
    }
    standardize(all, 0, p);
    standardize(all, p, beside.cols());
    const PrincipalDirections principal = principal_directions(all.view(), most_directions);
    const double total =
        std::accumulate(principal.variances.begin(), principal.variances.end(), 0.0);
    double sum = 0, variance = 0;
    std::vector<double> scales;
    for (std::size_t d = 0; d < principal.variances.size() && sum < variance_share * total; ++d) {
        sum += principal.variances[d];
        scales.push_back(std::pow(principal.variances[d], -evened / 2));
        variance += std::pow(principal.variances[d], 1 - evened);
    }
    const auto count = static_cast<std::int64_t>(scales.size());
    const double scale = std::sqrt(static_cast<double>(count) / variance);
    Matrix poses(n, count);
    for (std::int64_t i = 0; i < n; ++i)
        for (std::int64_t d = 0; d < count; ++d)
            poses(i, d) = scale * scales[static_cast<std::size_t>(d)] *
                          dot(all.row(i), principal.directions.row(d), all.cols());
    return poses;
}

Matrix with_velocities(ConstMatrixView poses, double rate, double seconds) {
    const std::int64_t n = poses.rows, p = poses.cols;
    Matrix both(n, 2 * p);
    for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t before = std::max<std::int64_t>(0, i - 1),
                           after = std::min(i + 1, n - 1);
        const double scale =
            after > before ? seconds * rate / static_cast<double>(after - before) : 0;
        for (std::int64_t c = 0; c < p; ++c) {
            both(i, c) = poses(i, c);
            both(i, p + c) = scale * (poses(after, c) - poses(before, c));
        }
    }
    return both;
}

Matrix windowed(ConstMatrixView x, double sigma) {
    Matrix squares = copied(x);
    for (std::int64_t i = 0; i < x.rows * x.cols; ++i)
        squares.data()[i] *= squares.data()[i];
    const Matrix mean = gaussian_smoothed(x, sigma, Beyond::nothing, 1);
    const Matrix square = gaussian_smoothed(squares.view(), sigma, Beyond::nothing, 1);
    Matrix result(mean.rows(), 2 * x.cols);
    for (std::int64_t i = 0; i < mean.rows(); ++i)
        for (std::int64_t c = 0; c < x.cols; ++c) {
            result(i, c) = mean(i, c);
            result(i, x.cols + c) =
                std::sqrt(std::max(0.0, square(i, c) - mean(i, c) * mean(i, c)));
        }
    return result;
}

} // namespace stltsa::motion
