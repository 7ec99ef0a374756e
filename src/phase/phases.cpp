// SPDX-License-Identifier: BSD-3-Clause
#include "phase/phases.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "motion/curve/statistics.hpp"

namespace stltsa::phase {
namespace {

/// Mean squared distance from the mean cycle, as a share of the variance, above which the phase is
/// linear in time: 0.1 is usual; a column that drifts gives 0.57, zeros for gaps 0.9.
constexpr double most_residual = 0.4;
constexpr double turn = 2 * std::numbers::pi;

double typical_length(std::span<const Sequence> sequences) {
    std::vector<double> lengths;
    for (const auto& [borders, begins_at] : sequences)
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

Run linear_run(const Sequence& sequence, std::int64_t rows) {
    const Borders& borders = sequence.borders;
    Run run{std::max<std::int64_t>(0, std::llround(borders.front())), {}};
    const std::int64_t end =
        std::min(rows, static_cast<std::int64_t>(std::llround(borders.back())));
    for (std::int64_t row = run.begin; row < end; ++row)
        run.phase.push_back(sequence.begins_at + linear_phase(borders, static_cast<double>(row)));
    return run;
}

/// Cycles of one sequence may begin elsewhere than those of another: all are shifted to the longest
/// one.
void align(ConstMatrixView rows, double period, std::vector<Run>& runs) {
    const auto longest = std::ranges::max_element(runs, {}, &Run::rows);
    const Loop loop = fit_loop(rows, {&*longest, 1}, harmonics_for(period));
    for (Run& run : runs) {
        if (&run == &*longest)
            continue;
        const Loop own = fit_loop(rows, {&run, 1}, harmonics_for(period));
        const double shift = offset_between(loop, own).shift;
        for (double& phase : run.phase)
            phase -= shift > 0.5 ? shift - 1 : shift;
    }
}

double phase_at(const Run& run, double row) {
    const double place =
        std::clamp(row - static_cast<double>(run.begin), 0.0, static_cast<double>(run.rows() - 1));
    const auto i = std::min(static_cast<std::size_t>(place), run.phase.size() - 2);
    return run.phase[i] + (place - static_cast<double>(i)) * (run.phase[i + 1] - run.phase[i]);
}

/// Circular mean of the phases at the borders, of those where the same side comes first.
double phase_at_borders(const std::vector<Run>& runs, std::span<const Sequence> sequences) {
    std::complex<double> sum = 0;
    for (std::size_t s = 0; s < runs.size(); ++s)
        for (const double border : sequences[s].borders)
            sum += std::polar(1.0, turn * (phase_at(runs[s], border) - sequences[s].begins_at));
    return std::arg(sum) / turn;
}

/// Weight of a column of a body without known sides: any weights do that are the same in every
/// recording and do not cancel. By the golden angle no few columns have like weights.
double fixed_weight(std::size_t column) {
    constexpr double golden_angle = 2.399963229728653;
    return std::cos(golden_angle * static_cast<double>(column));
}

/// The phase at which the body is at a known place: a weighted sum of the poses follows a wave over
/// the cycle, which has a peak, a valley and two passes between them. Of these four, the one
/// nearest to the borders of the cycles.
double body_zero(const Loop& loop, std::span<const double> side, double at_borders) {
    const auto features = static_cast<std::size_t>(loop.cols() / 2);
    double cosine = 0, sine = 0;
    for (std::size_t c = 0; c < features; ++c) {
        const double weight = side.empty() ? fixed_weight(c) : side[c];
        cosine += weight * loop.coefficients(1, static_cast<std::int64_t>(c));
        sine += weight * loop.coefficients(loop.harmonics() + 1, static_cast<std::int64_t>(c));
    }
    const double peak = std::atan2(sine, cosine) / turn;
    return peak + std::round((at_borders - peak) * 4) / 4;
}

void shift_zero(double zero, Phases& phases) {
    phases.mean.loop.shift(zero);
    for (Run& run : phases.runs)
        for (double& phase : run.phase)
            phase -= zero;
}

std::vector<Run> linear_runs(std::span<const Sequence> sequences, std::int64_t rows) {
    std::vector<Run> runs;
    for (const Sequence& sequence : sequences)
        runs.push_back(linear_run(sequence, rows));
    return runs;
}

/// Phases that begin as `runs`.
Phases registered(ConstMatrixView both, std::vector<Run> runs, double period) {
    Registration found = register_runs(both, runs, period);
    Phases phases;
    phases.mean = std::move(found.mean);
    phases.residual = found.residual;
    phases.linear = found.residual > most_residual;
    phases.runs = phases.linear ? std::move(runs) : std::move(found.runs);
    if (phases.linear)
        phases.mean.loop = fit_loop(both, phases.runs, harmonics_for(period));
    return phases;
}

} // namespace

Phases find_phases(ConstMatrixView rows, double rate, std::span<const Sequence> sequences,
                   std::span<const double> side) {
    const double period = typical_length(sequences);
    const Matrix both = pose_and_velocity(rows, rate, period);
    std::vector<Run> runs = linear_runs(sequences, rows.rows);
    align(both.view(), period, runs);
    Phases phases = registered(both.view(), std::move(runs), period);
    shift_zero(body_zero(phases.mean.loop, side, phase_at_borders(phases.runs, sequences)), phases);
    return phases;
}

Phases find_phases_of_repetitions(ConstMatrixView rows, double rate,
                                  std::span<const Sequence> repetitions) {
    const double period = typical_length(repetitions);
    const Matrix both = pose_and_velocity(rows, rate, period);
    Phases phases = registered(both.view(), linear_runs(repetitions, rows.rows), period);
    phases.cyclic = false;
    return phases;
}

} // namespace stltsa::phase
