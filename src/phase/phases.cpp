// SPDX-License-Identifier: BSD-3-Clause
#include "phase/phases.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/cycles/sides.hpp"

namespace stltsa::phase {
namespace {

/// Sides that swing less, see Wave, say nothing of the cycle.
constexpr double least_swing = 0.2;

double typical_length(std::span<const Borders> sequences) {
    std::vector<double> lengths;
    for (const Borders& borders : sequences)
        for (std::size_t i = 0; i + 1 < borders.size(); ++i)
            lengths.push_back(borders[i + 1] - borders[i]);
    return motion::median(lengths);
}

/// Phase of a row, linear in time between the borders and beyond them.
double linear_phase(const Borders& borders, double row) {
    const auto after = std::ranges::upper_bound(borders, row) - borders.begin();
    const auto i =
        std::clamp<std::ptrdiff_t>(after, 1, static_cast<std::ptrdiff_t>(borders.size()) - 1);
    const double begin = borders[static_cast<std::size_t>(i - 1)];
    const double end = borders[static_cast<std::size_t>(i)];
    return static_cast<double>(i - 1) + (row - begin) / (end - begin);
}

Run linear_run(const Borders& borders, std::int64_t rows) {
    Run run{std::max<std::int64_t>(0, std::llround(borders.front())), {}};
    const std::int64_t end =
        std::min(rows, static_cast<std::int64_t>(std::llround(borders.back())));
    for (std::int64_t row = run.begin; row < end; ++row)
        run.phase.push_back(linear_phase(borders, static_cast<double>(row)));
    return run;
}

/// Cycles of one sequence may begin elsewhere than those of another: all are shifted to the longest
/// one.
void align(ConstMatrixView rows, double period, std::vector<Run>& runs) {
    const auto longest = std::ranges::max_element(runs, {}, &Run::rows);
    const Loop loop = motion::fit_loop(rows, {&*longest, 1}, motion::harmonics_for(period));
    for (Run& run : runs) {
        if (&run == &*longest)
            continue;
        const Loop own = motion::fit_loop(rows, {&run, 1}, motion::harmonics_for(period));
        const double shift = motion::offset_between(loop, own).shift;
        for (double& phase : run.phase)
            phase -= shift > 0.5 ? shift - 1 : shift;
    }
}

/// First harmonic of a weighted sum of the poses over the mean cycle.
struct Wave {
    double peak = 0;  ///< its phase, in turns
    double share = 0; ///< amplitude; 1 if the columns move as the weights say and no other way
};

template <class Weight>
Wave wave_of(const Loop& loop, const Weight& weight_of) {
    const std::int64_t features = loop.cols() / 2;
    double cosine = 0, sine = 0, weights = 0, power = 0;
    for (std::int64_t c = 0; c < features; ++c) {
        const double weight = weight_of(static_cast<std::size_t>(c));
        const double a = loop.coefficients(1, c), b = loop.coefficients(loop.harmonics() + 1, c);
        cosine += weight * a;
        sine += weight * b;
        weights += weight * weight;
        power += a * a + b * b;
    }
    const double size = std::sqrt(weights * power);
    return {std::atan2(sine, cosine) / turn, size > 0 ? std::hypot(cosine, sine) / size : 0};
}

/// The phase at which the body is at a known place, wherever cycles begin: where the sides pass
/// each other, a quarter of a cycle after one of them is most forward; or, if the sides do not
/// swing, the peak of a sum with fixed weights.
double body_zero(const Loop& loop, std::span<const double> side) {
    if (!side.empty())
        if (const Wave sides = wave_of(loop, [&](std::size_t c) { return side[c]; });
            sides.share > least_swing)
            return sides.peak + 0.25;
    return wave_of(loop, motion::fixed_weight).peak;
}

void shift_zero(double zero, Phases& phases) {
    phases.mean.loop.shift(zero);
    for (Run& run : phases.runs)
        for (double& phase : run.phase)
            phase -= zero;
}

/// Where the borders lie in phase, on average over the circle: each is where the movement around
/// it, on both sides, is most like that around the others, while phases follow
/// each part of a cycle; they scatter about each other by 1 % of a cycle. To bend the phases so
/// that every border has the same one costs: annotated events then scatter by 0.75 % of a cycle
/// instead of 0.66 % on a treadmill, by 1.17 instead of 1.05 % overground (measure/phase).
double phase_of_borders(std::span<const Borders> sequences, const std::vector<Run>& runs) {
    double cosine = 0, sine = 0;
    for (std::size_t r = 0; r < runs.size(); ++r)
        for (const double border : sequences[r]) {
            const double angle = turn * runs[r].phase_at(border);
            cosine += std::cos(angle);
            sine += std::sin(angle);
        }
    return std::atan2(sine, cosine) / turn;
}

/// Begins to count with the first cycle of each sequence.
void count_from_first(std::span<const Borders> sequences, std::vector<Run>& runs) {
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const double first = std::round(runs[r].phase_at(sequences[r].front()));
        for (double& phase : runs[r].phase)
            phase -= first;
    }
}

std::vector<Run> linear_runs(std::span<const Borders> sequences, std::int64_t rows) {
    std::vector<Run> runs;
    for (const Borders& borders : sequences)
        runs.push_back(linear_run(borders, rows));
    return runs;
}

std::vector<std::vector<double>> distances_of(ConstMatrixView both, const MeanCycle& mean,
                                              const std::vector<Run>& runs) {
    std::vector<std::vector<double>> distances;
    for (const Run& run : runs)
        distances.push_back(motion::residuals(both, mean, run));
    return distances;
}

double mean_square(const std::vector<std::vector<double>>& all) {
    double squares = 0, count = 0;
    for (const std::vector<double>& some : all)
        for (const double each : some) {
            squares += each * each;
            ++count;
        }
    return squares / count;
}

/// Phases that begin as `runs`.
Phases registered(ConstMatrixView both, std::vector<Run> runs, double period) {
    motion::Registration found =
        motion::register_runs(both, runs, period, motion::smooth_share, motion::nearly_settled);
    Phases phases;
    phases.mean = std::move(found.mean);
    phases.runs = std::move(found.runs);
    phases.distances = distances_of(both, phases.mean, phases.runs);
    phases.residual = mean_square(phases.distances);
    phases.linear = phases.residual > most_residual;
    if (phases.linear) {
        phases.runs = std::move(runs);
        phases.mean.loop = motion::fit_loop(both, phases.runs, motion::harmonics_for(period));
        phases.distances = distances_of(both, phases.mean, phases.runs);
    }
    return phases;
}

} // namespace

Phases find_phases(ConstMatrixView rows, double rate, std::span<const Borders> sequences,
                   std::span<const double> side) {
    const double period = typical_length(sequences);
    const Matrix both = motion::pose_and_velocity(rows, rate, period);
    std::vector<Run> runs = linear_runs(sequences, rows.rows);
    align(both.view(), period, runs);
    Phases phases = registered(both.view(), std::move(runs), period);
    shift_zero(phase_of_borders(sequences, phases.runs), phases);
    count_from_first(sequences, phases.runs);
    phases.zero = body_zero(phases.mean.loop, side);
    phases.zero -= std::floor(phases.zero);
    return phases;
}

Phases find_phases_of_repetitions(ConstMatrixView rows, double rate,
                                  std::span<const Borders> repetitions) {
    const double period = typical_length(repetitions);
    const Matrix both = motion::pose_and_velocity(rows, rate, period);
    Phases phases = registered(both.view(), linear_runs(repetitions, rows.rows), period);
    phases.cyclic = false;
    return phases;
}

} // namespace stltsa::phase
