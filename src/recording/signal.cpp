// SPDX-License-Identifier: BSD-3-Clause
#include "recording/signal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "linalg/eigen.hpp"
#include "linalg/gaussian.hpp"
#include "linalg/simd.hpp"

namespace stltsa::recording {
namespace {

/// Enough for human motion; the lag map costs lags x rows.
constexpr double rows_per_second = 30;
/// The directions contain this share of the variance, or are as many as the limit.
constexpr double variance_share = 0.995;
constexpr std::int64_t most_directions = 16;
constexpr double velocity_smoothing_s = 0.04;
constexpr double speed_smoothing_s = 0.1;
/// A wave beside a run must count: speeds are compared with those of this time to each side.
/// Whether the body rests depends on less time, but noise beside a run is no motion.
constexpr double neighborhood_s = 8;
constexpr double near_s = 2;
constexpr double least_near = 0.15;
/// The noise of a body that rests for long is no motion either: share of the typical speed of all.
constexpr double least_usual = 0.04;

std::vector<double> means_of(ConstMatrixView x) {
    std::vector<double> mean(static_cast<std::size_t>(x.cols));
    for (std::int64_t i = 0; i < x.rows; ++i)
        axpy(1 / static_cast<double>(x.rows), x.row(i), mean.data(), x.cols);
    return mean;
}

/// Adds the outer products of `count` rows, which row_of(i, values) gives, divided by their trace.
template <class RowOf>
void add_covariance(std::int64_t count, const RowOf& row_of, Matrix& sums) {
    const std::int64_t cols = sums.cols();
    Matrix own(cols, cols);
    std::vector<double> row(static_cast<std::size_t>(cols));
    for (std::int64_t i = 0; i < count; ++i) {
        row_of(i, row.data());
        for (std::int64_t c = 0; c < cols; ++c)
            axpy(row[static_cast<std::size_t>(c)], row.data(), own.row(c), c + 1);
    }
    double trace = 0;
    for (std::int64_t c = 0; c < cols; ++c)
        trace += own(c, c);
    if (trace > 0)
        axpy(1 / trace, own.data(), sums.data(), cols * cols);
}

Matrix differences(ConstMatrixView x) {
    Matrix d(x.rows, x.cols);
    for (std::int64_t i = 0; i < x.rows && x.rows > 1; ++i) {
        const std::int64_t before = std::max<std::int64_t>(0, i - 1);
        const std::int64_t after = std::min(i + 1, x.rows - 1);
        for (std::int64_t c = 0; c < x.cols; ++c)
            d(i, c) = (x(after, c) - x(before, c)) / static_cast<double>(after - before);
    }
    return d;
}

std::vector<double> speeds(const Matrix& velocity, double sigma) {
    Matrix speed(velocity.rows(), 1);
    for (std::int64_t i = 0; i < velocity.rows(); ++i)
        speed(i, 0) = std::sqrt(dot(velocity.row(i), velocity.row(i), velocity.cols()));
    const Matrix smoothed = gaussian_smoothed(speed.view(), sigma, Beyond::nothing);
    return {smoothed.data(), smoothed.data() + smoothed.rows()};
}

/// Half of the distance is covered at this speed or faster.
double typical(std::vector<double> speed) {
    std::sort(speed.begin(), speed.end(), std::greater<>());
    const double half = std::accumulate(speed.begin(), speed.end(), 0.0) / 2;
    double covered = 0;
    for (const double v : speed)
        if ((covered += v) >= half)
            return v;
    return 0;
}

/// The typical speed around each second, linear between them.
std::vector<double> usual_speeds(const std::vector<double>& speed, double rate,
                                 double neighborhood) {
    const auto n = static_cast<std::int64_t>(speed.size());
    const auto hop = std::max<std::int64_t>(1, std::lround(rate));
    const auto reach = static_cast<std::int64_t>(neighborhood * rate);
    std::vector<double> at;
    for (std::int64_t t = 0; t < n + hop; t += hop)
        at.push_back(typical({speed.begin() + std::clamp<std::int64_t>(t - reach, 0, n - 1),
                              speed.begin() + std::min(n, t + reach)}));
    std::vector<double> usual(speed.size());
    for (std::int64_t i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i / hop);
        const double part = static_cast<double>(i % hop) / static_cast<double>(hop);
        usual[static_cast<std::size_t>(i)] = (1 - part) * at[k] + part * at[k + 1];
    }
    return usual;
}

/// How fast the rows usually change around each of them.
std::vector<double> usual_steps(ConstMatrixView x, double rate) {
    Matrix steps(x.rows, 1);
    for (std::int64_t i = 1; i < x.rows; ++i)
        steps(i, 0) = std::sqrt(squared_distance(x.row(i), x.row(i - 1), x.cols));
    const std::vector<double> speed(steps.data(), steps.data() + x.rows);
    std::vector<double> usual = usual_speeds(speed, rate, neighborhood_s);
    const double least = least_usual * typical(speed);
    for (double& step : usual)
        step = std::max(step, least);
    return usual;
}

/// Orthonormal directions with most of the variance of poses and of velocities, which count alike:
/// a tapping foot has little of the first on a swaying body. Velocities are relative to the usual
/// speed: it has little of the second beside a run.
Matrix directions_of(ConstMatrixView x, double rate) {
    Matrix sums(x.cols, x.cols);
    const std::vector<double> mean = means_of(x);
    add_covariance(
        x.rows,
        [&](std::int64_t i, double* row) {
            std::transform(x.row(i), x.row(i) + x.cols, mean.begin(), row, std::minus<>());
        },
        sums);
    const std::vector<double> usual = usual_steps(x, rate);
    add_covariance(
        x.rows - 1,
        [&](std::int64_t i, double* row) {
            const double scale = usual[static_cast<std::size_t>(i)];
            for (std::int64_t c = 0; c < x.cols; ++c)
                row[c] = scale > 0 ? (x(i + 1, c) - x(i, c)) / scale : 0;
        },
        sums);
    const std::int64_t most = std::min(x.cols, most_directions);
    TopEigenpairs pairs(x.cols, most);
    double total = 0;
    for (std::int64_t c = 0; c < x.cols; ++c) {
        total += sums(c, c);
        for (std::int64_t r = c; r < x.cols; ++r)
            pairs.matrix()[r + c * x.cols] = sums(r, c);
    }
    pairs.solve();
    std::int64_t count = 0;
    for (double sum = 0; count < most && (count == 0 || sum < variance_share * total); ++count)
        sum += pairs.value(count);
    Matrix directions(x.cols, count);
    for (std::int64_t d = 0; d < count; ++d)
        for (std::int64_t c = 0; c < x.cols; ++c)
            directions(c, d) = pairs.vector(d)[c];
    return directions;
}

Matrix projected(ConstMatrixView x, const Matrix& directions) {
    const std::vector<double> mean = means_of(x);
    Matrix result(x.rows, directions.cols());
    for (std::int64_t i = 0; i < x.rows; ++i)
        for (std::int64_t c = 0; c < x.cols; ++c)
            axpy(x(i, c) - mean[static_cast<std::size_t>(c)], directions.row(c), result.row(i),
                 directions.cols());
    return result;
}

Matrix every(ConstMatrixView samples, std::int64_t step) {
    Matrix rows = Matrix::unset((samples.rows + step - 1) / step, samples.cols);
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        std::copy_n(samples.row(i * step), samples.cols, rows.row(i));
    return rows;
}

} // namespace

Signal make_signal(ConstMatrixView samples, double fps) {
    Signal signal;
    signal.step = std::max<std::int64_t>(
        1, std::llround(std::min(fps / rows_per_second, static_cast<double>(samples.rows))));
    signal.rate = fps / static_cast<double>(signal.step);
    const Matrix thinned = signal.step > 1 ? every(samples, signal.step) : Matrix();
    const ConstMatrixView rows = signal.step > 1 ? thinned.view() : samples;
    signal.directions = directions_of(rows, signal.rate);
    signal.poses = projected(rows, signal.directions);
    signal.velocity = differences(
        gaussian_smoothed(signal.poses.view(), velocity_smoothing_s * signal.rate, Beyond::nothing)
            .view());
    signal.speed = speeds(signal.velocity, speed_smoothing_s * signal.rate);
    signal.usual = usual_speeds(signal.speed, signal.rate, neighborhood_s);
    signal.near_usual = usual_speeds(signal.speed, signal.rate, near_s);
    const double least = least_usual * typical(signal.speed);
    for (std::size_t i = 0; i < signal.usual.size(); ++i) {
        signal.usual[i] = std::max(signal.usual[i], least);
        signal.near_usual[i] =
            std::max(signal.near_usual[i], std::max(least_near * signal.usual[i], 2 * least));
    }
    return signal;
}

void row_at(ConstMatrixView rows, double place, double* values) {
    const double inside = std::clamp(place, 0.0, static_cast<double>(rows.rows - 1));
    const auto before =
        std::min(static_cast<std::int64_t>(inside), std::max<std::int64_t>(0, rows.rows - 2));
    const std::int64_t after = std::min(before + 1, rows.rows - 1);
    const double part = inside - static_cast<double>(before);
    for (std::int64_t c = 0; c < rows.cols; ++c)
        values[c] = (1 - part) * rows(before, c) + part * rows(after, c);
}

Matrix rows_at(ConstMatrixView rows, double begin, double end, std::int64_t count) {
    Matrix result(count, rows.cols);
    for (std::int64_t i = 0; i < count; ++i)
        row_at(rows, begin + (end - begin) * static_cast<double>(i) / static_cast<double>(count),
               result.row(i));
    return result;
}

} // namespace stltsa::recording
