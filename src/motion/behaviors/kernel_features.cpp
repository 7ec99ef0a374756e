// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/kernel_features.hpp"

#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "linalg/eigen.hpp"
#include "linalg/principal.hpp"
#include "linalg/simd.hpp"
#include "linalg/weighted_rows.hpp"
#include "motion/behaviors/poses.hpp"
#include "motion/behaviors/shapes.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// Samples of at most this many columns are described by their shapes. With three, a hand that
/// moves loses 13 of 772 cycles (measure/cycles).
constexpr std::int64_t few_columns = 2;
constexpr double moments_per_second = 10;
/// Sigma of the Gaussian window of the statistics; a velocity counts as the change in this time.
constexpr double statistics_window_s = 0.45;
/// Squared distance at which the kernel has fallen to 1/e: the median distance, but at least this
/// share of the total variance. Without that limit, one long motion is cut where nothing changes.
constexpr double least_bandwidth = 0.3;
/// The same for shapes, which are shares of time. Without it, half of the single columns of walks
/// on a treadmill are cut (measure/behaviors).
constexpr double least_of_shapes = 0.3;
constexpr std::int64_t distances_sampled = 400;
/// Between 40 and 240 landmarks give the same borders as the exact kernel.
constexpr std::int64_t most_landmarks = 120;
/// Smaller shares of the largest eigenvalue, and of a column's part in the directions, are 0.
constexpr double rounding = 1e-6;

/// `count` rows, evenly in time.
Matrix spread_rows(const Matrix& x, std::int64_t count) {
    count = std::min(count, x.rows());
    Matrix rows(count, x.cols());
    for (std::int64_t i = 0; i < count; ++i)
        std::copy_n(x.row(i * (x.rows() - 1) / std::max<std::int64_t>(1, count - 1)), x.cols(),
                    rows.row(i));
    return rows;
}

double median_distance(const Matrix& x) {
    const Matrix rows = spread_rows(x, distances_sampled);
    std::vector<double> distances;
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        for (std::int64_t k = 0; k < i; ++k)
            distances.push_back(squared_distance(rows.row(i), rows.row(k), rows.cols()));
    return median(distances);
}

/// landmarks x features: kernel values at the landmarks times this are the features.
Matrix nystroem_map(const Matrix& landmarks, double bandwidth) {
    const std::int64_t m = landmarks.rows();
    TopEigenpairs pairs(m, m);
    for (std::int64_t c = 0; c < m; ++c)
        for (std::int64_t r = c; r < m; ++r)
            pairs.matrix()[r + c * m] =
                std::exp(-squared_distance(landmarks.row(r), landmarks.row(c), landmarks.cols()) /
                         bandwidth);
    pairs.solve();
    std::int64_t count = 0;
    while (count < m && pairs.value(count) > rounding * pairs.value(0))
        ++count;
    Matrix map(m, count);
    for (std::int64_t f = 0; f < count; ++f)
        for (std::int64_t l = 0; l < m; ++l)
            map(l, f) = pairs.vector(f)[l] / std::sqrt(pairs.value(f));
    return map;
}

std::int64_t moving_columns(const Signal& signal) {
    std::int64_t count = 0;
    for (std::int64_t c = 0; c < signal.directions.rows(); ++c)
        count += dot(signal.directions.row(c), signal.directions.row(c), signal.directions.cols()) >
                 rounding;
    return count;
}

} // namespace

KernelFeatures::KernelFeatures(const Signal& signal, const Matrix& beside)
    : step_(std::max<std::int64_t>(1, std::lround(signal.rate / moments_per_second))) {
    double least = 0;
    Matrix statistics;
    if (moving_columns(signal) <= few_columns) {
        Shapes shapes = make_shapes(signal.poses.view());
        of_shapes_ = shapes.rows.rows() > 0;
        if (of_shapes_) {
            step_ = shapes.step;
            statistics = shapes.rows;
            poses_ = std::move(shapes.rows);
            least = least_of_shapes;
        }
    }
    if (!of_shapes_) {
        poses_ = even_poses(signal, beside, step_);
        const double rate = signal.rate / static_cast<double>(step_);
        const Matrix x = with_velocities(poses_.view(), rate, statistics_window_s);
        statistics = windowed(x.view(), statistics_window_s * rate);
        least = least_bandwidth * total_variance(x.view());
    }
    const double bandwidth = std::max(median_distance(statistics), least);
    const Matrix landmarks = spread_rows(statistics, most_landmarks);
    const Matrix map = nystroem_map(landmarks, bandwidth > 0 ? bandwidth : 1);
    sums_ = Matrix(statistics.rows() + 1, map.cols());
    squares_.assign(static_cast<std::size_t>(statistics.rows() + 1), 0);
    std::vector<double> feature(static_cast<std::size_t>(map.cols()));
    std::vector<double> kernel(static_cast<std::size_t>(landmarks.rows()));
    for (std::int64_t i = 0; i < statistics.rows(); ++i) {
        checkpoint(landmarks.rows() * (landmarks.cols() + map.cols()));
        std::fill(feature.begin(), feature.end(), 0.0);
        for (std::int64_t l = 0; l < landmarks.rows(); ++l)
            kernel[static_cast<std::size_t>(l)] =
                std::exp(-squared_distance(statistics.row(i), landmarks.row(l), landmarks.cols()) /
                         (bandwidth > 0 ? bandwidth : 1));
        add_weighted(map.view(), kernel.data(), 1, feature.data());
        std::copy_n(sums_.row(i), map.cols(), sums_.row(i + 1));
        axpy(1, feature.data(), sums_.row(i + 1), map.cols());
        squares_[static_cast<std::size_t>(i + 1)] =
            squares_[static_cast<std::size_t>(i)] + dot(feature.data(), feature.data(), map.cols());
    }
}

Rows KernelFeatures::moments(Rows rows) const {
    const std::int64_t begin = std::min(rows.begin / step_, count() - 1);
    return {begin, std::clamp((rows.end + step_ - 1) / step_, begin + 1, count())};
}

void KernelFeatures::add_sum(Rows moments, double* sum) const {
    for (std::int64_t f = 0; f < sums_.cols(); ++f)
        sum[f] += sums_(moments.end, f) - sums_(moments.begin, f);
}

double KernelFeatures::cost(std::int64_t begin, std::int64_t end) const {
    return squares_[static_cast<std::size_t>(end)] - squares_[static_cast<std::size_t>(begin)] -
           squared_distance(sums_.row(end), sums_.row(begin), sums_.cols()) /
               static_cast<double>(end - begin);
}

double KernelFeatures::gain(std::int64_t begin, std::int64_t middle, std::int64_t end) const {
    return cost(begin, end) - cost(begin, middle) - cost(middle, end);
}

double KernelFeatures::gain(Rows a, Rows b) const {
    const auto m = static_cast<double>(a.count()), n = static_cast<double>(b.count());
    double apart = 0; // squared distance of the means
    for (std::int64_t f = 0; f < sums_.cols(); ++f) {
        const double d =
            (sums_(a.end, f) - sums_(a.begin, f)) / m - (sums_(b.end, f) - sums_(b.begin, f)) / n;
        apart += d * d;
    }
    return m * n / (m + n) * apart;
}

} // namespace stltsa::motion
