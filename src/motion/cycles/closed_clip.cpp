// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/closed_clip.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"

namespace stltsa::motion {
namespace {

constexpr std::int64_t min_loop_rows = 12;
/// The last row is at most so far from where the first row goes on, as a share of a step from row
/// to row there and of the clip's extent; and it moves there at this share of its usual speed.
constexpr double max_apart = 0.8;
constexpr double max_gap = 0.1;
constexpr double in_motion = 0.4;
/// Share of right answers among these (measure/cycles: closed, acyclic).
constexpr double right = 0.9;
constexpr std::int64_t copies = 3;

bool is_closed(const Signal& signal, const PeriodRange& periods) {
    const std::int64_t n = signal.rows();
    const double seconds = static_cast<double>(n) / signal.rate;
    if (n < min_loop_rows || seconds < periods.shortest_s || seconds > periods.longest_s)
        return false;
    double extent = 0;
    for (std::int64_t i = 0; i < n; ++i)
        extent = std::max(
            extent, squared_distance(signal.poses.row(i), signal.poses.row(0), signal.cols()));
    const auto p = static_cast<std::size_t>(signal.cols());
    std::vector<double> step(p), gap(p); // from row to row beside the ends, and over them
    for (std::size_t c = 0; c < p; ++c) {
        const auto at = static_cast<std::int64_t>(c);
        step[c] = (signal.poses(2, at) - signal.poses(0, at) + signal.poses(n - 1, at) -
                   signal.poses(n - 3, at)) /
                  4;
        gap[c] = signal.poses(0, at) - signal.poses(n - 1, at);
    }
    // The last row may be the first one again, or the one before it.
    const double length = dot(step.data(), step.data(), signal.cols());
    const double along = dot(gap.data(), step.data(), signal.cols()) / length;
    axpy(-std::clamp(along, 0.0, 1.5), step.data(), gap.data(), signal.cols());
    const double apart = dot(gap.data(), gap.data(), signal.cols());
    const double usual = in_motion * signal.usual.front();
    return length > usual * usual && apart < max_apart * max_apart * length &&
           apart < max_gap * max_gap * extent;
}

/// The poses as they are played in a loop.
Signal repeated(const Signal& signal) {
    Signal loop;
    loop.rate = signal.rate;
    loop.poses = Matrix(copies * signal.rows(), signal.cols());
    for (std::int64_t k = 0; k < copies; ++k)
        std::copy_n(signal.poses.data(), signal.rows() * signal.cols(),
                    loop.poses.row(k * signal.rows()));
    return loop;
}

} // namespace

std::optional<CyclicStretch> closed_cycle(const Signal& signal, const PeriodRange& periods) {
    if (!is_closed(signal, periods))
        return {};
    const std::int64_t n = signal.rows();
    const Signal loop = repeated(signal);
    const Rows all{0, copies * n};
    const Stretch stretch{
        all, std::vector<double>(static_cast<std::size_t>(all.end), static_cast<double>(n)), 1};
    CyclicStretch cut;
    cut.stretch = {
        {0, n}, std::vector<double>(static_cast<std::size_t>(n), static_cast<double>(n)), 1};
    cut.growth = grow(loop, stretch, all);
    // The middle copy, which has a neighbor on each side.
    Run& run = cut.growth.run;
    if (run.begin > n || run.end() <= 2 * n)
        return {};
    Growth turn = cut.growth; // with the row that closes the loop
    const auto first = run.phase.begin() + (n - run.begin);
    turn.run = {n, {first, first + n + 1}};
    cut.phase = trace_phase(loop, turn);
    for (double& place : cut.phase.places)
        place -= static_cast<double>(n);
    const auto keep = [&](std::vector<double>& values) {
        const auto from = values.begin() + (n - run.begin);
        values = {from, from + n};
    };
    keep(cut.growth.deviation);
    keep(run.phase);
    run.begin = 0;
    cut.borders = {0, static_cast<double>(n)};
    cut.confidences = {right};
    return cut;
}

} // namespace stltsa::motion
