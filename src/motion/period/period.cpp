// SPDX-License-Identifier: BSD-3-Clause
#include "motion/period/period.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"
#include "motion/curve/extrema.hpp"

namespace stltsa::motion {
namespace {

/// Lags longer than this share of the clip leave too few pairs.
constexpr double longest_share = 0.7;
/// A minimum of D counts if D was higher by this at a shorter lag (D is 0 to 2; in gait it falls by
/// 1.5, and values from 0.1 to 0.25 give the same result).
constexpr double least_depth = 0.15;
constexpr double unrelated = 1;
/// A lag is preferred to its multiples unless they are better by more than this.
constexpr double about_as_good = 0.2;
/// At least this share of a period must move and occur twice: less may repeat by chance.
constexpr double least_repeated = 0.4;
constexpr double rows_per_second = 30;

/// Sums over the pairs of one lag.
struct PairSums {
    explicit PairSums(std::int64_t cols)
        : early(static_cast<std::size_t>(cols)), late(static_cast<std::size_t>(cols)) {}

    void add(const LagSamples& samples, std::int64_t row, std::int64_t later_row) {
        const auto t = static_cast<std::size_t>(row);
        const auto later_t = static_cast<std::size_t>(later_row);
        const double w = samples.level[t] * samples.level[later_t];
        if (!(w > 0))
            return;
        const double* x = samples.x.row(row);
        const double* later = samples.x.row(later_row);
        const std::int64_t cols = samples.x.cols();
        weight += w;
        distance += w * squared_distance(later, x, cols);
        size += w * (samples.norm[t] + samples.norm[later_t]);
        axpy(w, x, early.data(), cols);
        axpy(w, later, late.data(), cols);
    }

    double ratio() const {
        const auto cols = static_cast<std::int64_t>(early.size());
        if (!(weight > 0))
            return 1;
        const double size_about_means =
            size -
            (dot(early.data(), early.data(), cols) + dot(late.data(), late.data(), cols)) / weight;
        const double distance_about_means =
            distance - squared_distance(early.data(), late.data(), cols) / weight;
        // Smaller sums are only rounding.
        return size_about_means > 1e-12 * size ? distance_about_means / size_about_means : 1;
    }

    double weight = 0;
    double distance = 0;
    double size = 0;
    std::vector<double> early; ///< weighted sum of x, per feature
    std::vector<double> late;
};

bool seen_twice(const LagSamples& samples, std::int64_t lag) {
    std::int64_t pairs = 0;
    for (std::size_t t = 0, later = static_cast<std::size_t>(lag); later < samples.level.size();
         ++t, ++later)
        pairs += is_moving(samples.level[t]) && is_moving(samples.level[later]) ? 1 : 0;
    return static_cast<double>(pairs) >= least_repeated * static_cast<double>(lag);
}

/// The lags in rows at which the curve has a minimum that may be the period.
std::vector<std::size_t> minima_of(const std::vector<double>& curve, double shortest,
                                   const LagSamples& samples) {
    // At short lags D is small because the motion is smooth: start where D has risen.
    const double half = *std::max_element(curve.begin(), curve.end()) / 2;
    const auto risen = std::find_if(curve.begin(), curve.end(), [&](double d) { return d > half; });
    const auto start = std::max({static_cast<std::size_t>(risen - curve.begin()),
                                 static_cast<std::size_t>(std::ceil(shortest)), std::size_t{1}});
    std::vector<std::size_t> minima;
    double highest = 0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const bool minimum = i >= start && curve[i] <= curve[i - 1] && curve[i] < curve[i + 1];
        if (minimum && curve[i] < unrelated && highest - curve[i] >= least_depth &&
            seen_twice(samples, static_cast<std::int64_t>(i)))
            minima.push_back(i);
        highest = std::max(highest, curve[i]);
    }
    return minima;
}

Period at_minimum(const std::vector<double>& curve, std::size_t i, std::int64_t first_lag,
                  std::int64_t step) {
    const double shift = parabola_vertex(curve[i - 1], curve[i], curve[i + 1]);
    const double rows = static_cast<double>(first_lag) + static_cast<double>(i) + shift;
    return {rows * static_cast<double>(step), 1 - curve[i]};
}

} // namespace

LagSamples::LagSamples(ConstMatrixView samples, std::span<const double> levels, double fps,
                       const Progress& progress)
    : step(std::llround(std::clamp(fps / rows_per_second, 1.0,
                                   std::max(1.0, static_cast<double>(samples.rows))))),
      x(Matrix::unset((samples.rows + step - 1) / step, samples.cols)) {
    PacedPoll poll(progress, Stage::neighbors);
    std::vector<double> mean(static_cast<std::size_t>(x.cols()));
    for (std::int64_t i = 0; i < x.rows(); ++i) {
        axpy(1 / static_cast<double>(x.rows()), samples.row(i * step), mean.data(), x.cols());
        poll.did(x.cols());
    }
    for (std::int64_t i = 0; i < x.rows(); ++i) {
        std::copy_n(samples.row(i * step), x.cols(), x.row(i));
        axpy(-1, mean.data(), x.row(i), x.cols());
        level.push_back(levels[static_cast<std::size_t>(i * step)]);
        norm.push_back(dot(x.row(i), x.row(i), x.cols()));
        poll.did(x.cols());
    }
}

std::vector<double> lag_curve(const LagSamples& samples, std::int64_t first, std::int64_t last,
                              const Progress& progress) {
    std::vector<double> curve;
    for (std::int64_t lag = first; lag <= last; ++lag) {
        const double fraction =
            static_cast<double>(lag - first) / static_cast<double>(last - first + 1);
        progress.report(Stage::neighbors, fraction);
        PacedPoll poll(progress, Stage::neighbors, fraction);
        PairSums sums(samples.x.cols());
        for (std::int64_t t = 0; t + lag < samples.x.rows(); ++t) {
            sums.add(samples, t, t + lag);
            poll.did(samples.x.cols());
        }
        curve.push_back(sums.ratio());
    }
    return curve;
}

double longest_lag_s(std::int64_t samples, double fps, double longest_s) {
    return std::min(longest_s, longest_share * static_cast<double>(samples) / fps);
}

Period find_period(ConstMatrixView samples, const Activity& activity, double fps, double shortest_s,
                   double longest_s, const Progress& progress) {
    const LagSamples decimated(samples, activity.level, fps, progress);
    const double rate = fps / static_cast<double>(decimated.step);
    const double longest = longest_lag_s(decimated.x.rows(), rate, longest_s) * rate;
    if (!(longest >= 3) || !(activity.typical > 0))
        return {};
    const std::vector<double> curve =
        lag_curve(decimated, 0, static_cast<std::int64_t>(longest), progress.part(0, 2));
    const std::vector<std::size_t> minima = minima_of(curve, shortest_s * rate, decimated);
    double best = unrelated;
    for (const std::size_t i : minima)
        best = std::min(best, curve[i]);
    for (const std::size_t i : minima)
        if (curve[i] <= best + about_as_good)
            return at_minimum(curve, i, 0, decimated.step);
    return {};
}

Period find_period(ConstMatrixView samples, double fps, double shortest_s, double longest_s,
                   const Progress& progress) {
    const auto poll = [&] { progress.report(Stage::features, 1); };
    return find_period(samples, measure_activity(samples, fps, poll), fps, shortest_s, longest_s,
                       progress);
}

} // namespace stltsa::motion
