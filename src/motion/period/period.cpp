// SPDX-License-Identifier: BSD-3-Clause
#include "motion/period/period.hpp"

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/extrema.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// A little more than the 3 % that the lags of the track are apart.
constexpr double most_off = 0.04;

/// The lag in rows, within most_off of the median period of the stretch, at which its velocities
/// match best.
double best_lag(const Signal& signal, const Stretch& stretch) {
    const auto match = [&](std::int64_t lag) {
        double both = 0, energy = 0;
        for (std::int64_t row = stretch.rows.begin; row + lag < stretch.rows.end; ++row) {
            const double *v = signal.velocity.row(row), *later = signal.velocity.row(row + lag);
            both += 2 * dot(v, later, signal.cols());
            energy += dot(v, v, signal.cols()) + dot(later, later, signal.cols());
        }
        return energy > 0 ? both / energy : 0;
    };
    const double tracked = median(stretch.period);
    const std::int64_t reach = std::max<std::int64_t>(1, std::lround(most_off * tracked));
    std::int64_t best = std::lround(tracked);
    for (std::int64_t lag = std::lround(tracked) - reach; lag <= std::lround(tracked) + reach;
         ++lag)
        if (match(lag) > match(best))
            best = lag;
    return static_cast<double>(best) +
           parabola_vertex(match(best - 1), match(best), match(best + 1));
}

} // namespace

Period find_period(ConstMatrixView samples, double fps, const PeriodRange& range) {
    constexpr std::int64_t min_samples = 4;
    if (samples.rows < min_samples)
        return {};
    const Signal signal = make_signal(samples, fps, 0, 0);
    report_progress(Stage::neighbors, 0);
    const PeriodTrack track = track_period(signal, {0, signal.rows()}, range);
    const auto best = std::ranges::max_element(track.stretches, {}, [](const Stretch& stretch) {
        return static_cast<double>(stretch.rows.count()) * stretch.quality;
    });
    if (best == track.stretches.end() ||
        static_cast<double>(best->rows.count()) < min_turns * median(best->period))
        return {};
    return {best_lag(signal, *best) * static_cast<double>(signal.step), best->quality};
}

} // namespace stltsa::motion
