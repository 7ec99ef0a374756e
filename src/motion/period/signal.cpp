// SPDX-License-Identifier: BSD-3-Clause
#include "motion/period/signal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/progress.hpp"
#include "linalg/gaussian.hpp"
#include "linalg/principal.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/period/directions.hpp"

namespace stltsa::motion {
namespace {

/// Enough for human motion; the lag map costs lags x rows.
constexpr double rows_per_second = 30;
constexpr double velocity_smoothing_s = 0.04;
/// Poses are smoothed if noise is more than this share of the typical speed.
constexpr double pose_smoothing_s[] = {0, 0.045, 0.08};
constexpr double most_noise = 0.2;
/// Noise is measured where there is least: in the quietest tenth of spans of so many rows. Its
/// variance is larger by this factor on the average.
constexpr std::int64_t quiet_rows = 10;
constexpr double quiet_share = 0.1;
constexpr double quiet_bias = 1.4;
/// Times the noise, which is also what is left of it.
constexpr double above_noise = 4;
constexpr double speed_smoothing_s = 0.1;
/// A wave beside a run must count: speeds are compared with those of this time to each side.
/// Whether the body rests depends on less time, but noise beside a run is no motion.
constexpr double neighborhood_s = 8;
constexpr double near_s = 2;
constexpr double least_near = 0.15;
/// The noise of a body that rests for long is no motion either: share of the typical speed of all.
constexpr double least_usual = 0.04;
/// A body that only sways stands: its size per second. A rest is slower than a quarter of that:
/// joints that are 0.5 m from the hips move at 1.5 cm/s.
constexpr double least_of_size = 0.12;
/// Work of sorting a number, for checkpoint().
constexpr std::int64_t sorting = 32;

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

Matrix velocities(const Matrix& poses, double sigma) {
    return differences(gaussian_smoothed(poses.view(), sigma, Beyond::nothing, 1).view());
}

double third_difference(const Matrix& x, std::int64_t i, std::int64_t c) {
    return x(i + 3, c) - x(i, c) - 3 * (x(i + 2, c) - x(i + 1, c));
}

/// Sum of the squared third differences of the rows from `first` on.
double roughness(const Matrix& x, std::int64_t first, std::int64_t count) {
    double total = 0;
    for (std::int64_t i = first; i < first + count; ++i)
        for (std::int64_t c = 0; c < x.cols(); ++c)
            total += third_difference(x, i, c) * third_difference(x, i, c);
    return total;
}

/// A single one, smoothed: what becomes of white noise.
Matrix impulse(double sigma, std::int64_t reach) {
    Matrix one(2 * reach + 1, 1);
    one(reach, 0) = 1;
    return sigma > 0 ? gaussian_smoothed(one.view(), sigma, Beyond::nothing) : one;
}

/// The variance of velocities() of smoothed noise, in mean squared third differences before the
/// smoothing by `more`.
double noise_in_velocities(double smoothed, double more, double sigma) {
    const double all = std::hypot(smoothed, more);
    const auto reach = static_cast<std::int64_t>(std::ceil(6 * (all + sigma))) + 3;
    const Matrix before = impulse(smoothed, reach);
    const Matrix velocity = velocities(impulse(all, reach), sigma);
    return dot(velocity.data(), velocity.data(), velocity.rows()) /
           roughness(before, 0, before.rows() - 3);
}

/// Mean squared third difference where it is least: of noise alone, since smooth motion hardly has
/// any.
double least_roughness(const Matrix& x) {
    std::vector<double> means;
    for (std::int64_t i = 0; i + quiet_rows + 3 <= x.rows(); i += quiet_rows)
        means.push_back(roughness(x, i, quiet_rows) / static_cast<double>(quiet_rows));
    return means.empty() ? 0 : quiet_bias * quantile(means, quiet_share);
}

std::vector<double> speeds(const Matrix& velocity, double sigma) {
    Matrix speed(velocity.rows(), 1);
    for (std::int64_t i = 0; i < velocity.rows(); ++i)
        speed(i, 0) = std::sqrt(dot(velocity.row(i), velocity.row(i), velocity.cols()));
    const Matrix smoothed = gaussian_smoothed(speed.view(), sigma, Beyond::nothing, 1);
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
    for (std::int64_t t = 0; t < n + hop; t += hop) {
        checkpoint(sorting * 2 * reach);
        at.push_back(typical({speed.begin() + std::clamp<std::int64_t>(t - reach, 0, n - 1),
                              speed.begin() + std::min(n, t + reach)}));
    }
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
    for (std::int64_t i = 1; i < x.rows; ++i) {
        steps(i, 0) = std::sqrt(squared_distance(x.row(i), x.row(i - 1), x.cols));
        checkpoint(x.cols);
    }
    const std::vector<double> speed(steps.data(), steps.data() + x.rows);
    std::vector<double> usual = usual_speeds(speed, rate, neighborhood_s);
    const double least = least_usual * typical(speed);
    for (double& step : usual)
        step = std::max(step, least);
    return usual;
}

Matrix projected(ConstMatrixView x, const Matrix& directions) {
    const std::vector<double> mean = column_means(x);
    Matrix result(x.rows, directions.cols());
    for (std::int64_t i = 0; i < x.rows; ++i) {
        checkpoint(x.cols * directions.cols());
        for (std::int64_t c = 0; c < x.cols; ++c)
            axpy(x(i, c) - mean[static_cast<std::size_t>(c)], directions.row(c), result.row(i),
                 directions.cols());
    }
    return result;
}

Matrix every(ConstMatrixView samples, std::int64_t step) {
    Matrix rows = Matrix::unset((samples.rows + step - 1) / step, samples.cols);
    for (std::int64_t i = 0; i < rows.rows(); ++i) {
        std::copy_n(samples.row(i * step), samples.cols, rows.row(i));
        checkpoint(samples.cols);
    }
    return rows;
}

} // namespace

Signal make_signal(ConstMatrixView samples, double fps, double smoothed_s, double size) {
    report_progress(Stage::features, 1);
    Signal signal;
    signal.step = std::max<std::int64_t>(
        1, std::llround(std::min(fps / rows_per_second, static_cast<double>(samples.rows))));
    signal.rate = fps / static_cast<double>(signal.step);
    const Matrix thinned = signal.step > 1 ? every(samples, signal.step) : Matrix();
    const ConstMatrixView rows = signal.step > 1 ? thinned.view() : samples;
    signal.directions = leading_directions(rows, usual_steps(rows, signal.rate));
    const Matrix poses = projected(rows, signal.directions);
    const double rough = least_roughness(poses), sigma = velocity_smoothing_s * signal.rate;
    double noise = 0, all = 0;
    for (const double seconds : pose_smoothing_s) {
        const double more = seconds * signal.rate;
        signal.poses =
            more > 0 ? gaussian_smoothed(poses.view(), more, Beyond::reflection, 1) : poses;
        // Reflection would make noise at the ends twice as large: a body that stands would move.
        signal.velocity = velocities(poses, std::hypot(more, sigma));
        signal.speed = speeds(signal.velocity, std::hypot(speed_smoothing_s * signal.rate, more));
        checkpoint();
        noise = rough > 0
                    ? std::sqrt(rough * noise_in_velocities(smoothed_s * signal.rate, more, sigma))
                    : 0;
        all = typical(signal.speed);
        if (noise <= most_noise * all)
            break;
    }
    signal.usual = usual_speeds(signal.speed, signal.rate, neighborhood_s);
    for (double& speed : signal.speed)
        speed = std::sqrt(std::max(0.0, speed * speed - noise * noise));
    signal.near_usual = usual_speeds(signal.speed, signal.rate, near_s);
    const double least = least_usual * all;
    const double standing = least_of_size * size / signal.rate;
    for (std::size_t i = 0; i < signal.usual.size(); ++i) {
        signal.usual[i] = std::max(signal.usual[i], least);
        signal.near_usual[i] = std::max({signal.near_usual[i], least_near * signal.usual[i],
                                         2 * least, above_noise * noise, standing});
    }
    return signal;
}

void report_row(const Signal& signal, double row) {
    report_progress(Stage::units, std::min(row / static_cast<double>(signal.rows()), 1.0));
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

} // namespace stltsa::motion
