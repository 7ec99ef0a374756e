// SPDX-License-Identifier: BSD-3-Clause
#include "recording/margin_alignment.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"

namespace stltsa::recording {
namespace {

// Deviation of the period, mean of 13 noisy synthetic walks and of 8 real walks and runs
// (measure/clips): 0.50 % and 1.7 % without alignment, 0.20 % and 1.1 % with it; 0.26 % and 1.5 %
// if velocities are compared a quarter of a cycle before and after; 0.46 % and 1.1 % with
// velocities from all of the clip. Cycles of exact sines differ by 1 to 3 % without alignment, and
// by at most 0.13 % with it.

/// Number of places at which velocities are compared.
constexpr std::int64_t places = 25;
/// The first place is so much of a cycle before the margin, the last so much after it.
constexpr double around_margin = 0.5;
constexpr double between_places = 2 * around_margin / (places - 1);
/// Most of a cycle before the first margin and after the last one: beyond, the motion is another.
constexpr double beyond = 0.25;
/// Seconds at the ends of the clip in which smoothing bends the curves of the features.
constexpr double bent_s = 0.15;
/// Most that a margin moves, as a share of a cycle: half of it gives the same figures, and with an
/// eighth of it margins do not get where they belong.
constexpr double most_moved = 0.24;
/// The rounds end if no margin moves by more than this share of a cycle.
constexpr double settled = 1e-4;
constexpr int most_rounds = 8;
/// Most of a cycle that the clip may be too short for the aligned margins.
constexpr double most_missing = 0.1;
/// Least distance between margins, relative to that before.
constexpr double least_distance = 0.4;

/// From each margin to the next; around a margin, the mean of both.
std::vector<double> lengths_between(const std::vector<double>& margins) {
    std::vector<double> lengths;
    const std::size_t last = margins.size() - 1;
    for (std::size_t k = 0; k <= last; ++k) {
        const std::size_t from = k == 0 ? 0 : k - 1, to = std::min(k + 1, last);
        lengths.push_back((margins[to] - margins[from]) / static_cast<double>(to - from));
    }
    return lengths;
}

/// Every second margin of a sequence, in rows.
struct Kind {
    std::vector<double> start;
    std::vector<double> at;
    std::vector<double> length; ///< of the cycle around each
    double first = 0, last = 0; ///< margins of the sequence
};

Kind kind_of(const std::vector<double>& margins, std::size_t from) {
    Kind kind;
    for (std::size_t i = from; i < margins.size(); i += 2)
        kind.start.push_back(margins[i]);
    kind.at = kind.start;
    kind.length = lengths_between(kind.at);
    kind.first = margins.front();
    kind.last = margins.back();
    return kind;
}

/// Calls `visit(p, velocity)` for the places around a margin. The velocity is per cycle.
template <class Visit>
void around(const Signal& signal, const Kind& kind, std::size_t k, Visit visit) {
    const double bent = 1 + bent_s * signal.rate, length = kind.length[k];
    const double from = std::max(bent, kind.first - beyond * length);
    const double to =
        std::min(static_cast<double>(signal.rows() - 1) - bent, kind.last + beyond * length);
    std::vector<double> velocity(static_cast<std::size_t>(signal.cols())), before = velocity;
    for (std::int64_t p = 0; p < places; ++p) {
        const double at =
            kind.at[k] + (static_cast<double>(p) * between_places - around_margin) * length;
        if (at < from || at > to)
            continue;
        row_at(signal.poses.view(), at + 1, velocity.data());
        row_at(signal.poses.view(), at - 1, before.data());
        for (std::size_t c = 0; c < velocity.size(); ++c)
            velocity[c] = (velocity[c] - before[c]) * length / 2;
        visit(p, velocity.data());
    }
}

/// The mean velocity at each place.
Matrix mean_of(const Signal& signal, const Kind& kind) {
    Matrix mean(places, signal.cols());
    std::vector<double> counts(places);
    for (std::size_t k = 0; k < kind.at.size(); ++k)
        around(signal, kind, k, [&](std::int64_t p, const double* velocity) {
            axpy(1, velocity, mean.row(p), signal.cols());
            counts[static_cast<std::size_t>(p)] += 1;
        });
    for (std::int64_t p = 0; p < places; ++p)
        for (std::int64_t c = 0; c < signal.cols(); ++c)
            mean(p, c) /= std::max(1.0, counts[static_cast<std::size_t>(p)]);
    return mean;
}

/// Its derivative by the share of a cycle.
Matrix slope_of(const Matrix& mean) {
    Matrix slope(places, mean.cols());
    for (std::int64_t p = 0; p < places; ++p) {
        const std::int64_t from = std::max<std::int64_t>(0, p - 1);
        const std::int64_t to = std::min(p + 1, places - 1);
        const double scale = 1 / (static_cast<double>(to - from) * between_places);
        axpy(scale, mean.row(to), slope.row(p), mean.cols());
        axpy(-scale, mean.row(from), slope.row(p), mean.cols());
    }
    return slope;
}

/// Gauss-Newton steps towards the mean, in rows.
std::vector<double> steps_of(const Signal& signal, const Kind& kind) {
    const Matrix mean = mean_of(signal, kind), slope = slope_of(mean);
    std::vector<double> steps;
    for (std::size_t k = 0; k < kind.at.size(); ++k) {
        double along = 0, square = 0;
        around(signal, kind, k, [&](std::int64_t p, const double* velocity) {
            along += dot(velocity, slope.row(p), signal.cols()) -
                     dot(mean.row(p), slope.row(p), signal.cols());
            square += dot(slope.row(p), slope.row(p), signal.cols());
        });
        steps.push_back(square > 0 ? -along / square * kind.length[k] : 0);
    }
    return steps;
}

/// Moves the margins once; returns the largest move as a share of a cycle.
double move(const Signal& signal, Kind& kind) {
    const std::vector<double> steps = steps_of(signal, kind);
    const std::size_t count = kind.at.size();
    double common = 0;
    for (std::size_t k = 0; k < count; ++k)
        common += (kind.at[k] + steps[k] - kind.start[k]) / static_cast<double>(count);
    double largest = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double most = most_moved * kind.length[k];
        const double moved = kind.at[k] + steps[k] - common - kind.start[k];
        const double to = kind.start[k] + std::clamp(moved, -most, most);
        largest = std::max(largest, std::abs(to - kind.at[k]) / kind.length[k]);
        kind.at[k] = to;
    }
    // Otherwise time would run faster around a margin that was too early, which matters where the
    // motion on one side only is compared: around the first and the last.
    kind.length = lengths_between(kind.at);
    return largest;
}

/// Shifts all margins by the same amount if one left the rows from `begin` to `end`. If the rows
/// are too few, because the clip is as long as its cycles, the outer cycles lose what is missing;
/// false if that is too much.
bool keep_inside(double begin, double end, Kind& kind) {
    const auto [lowest, highest] = std::ranges::minmax(kind.at);
    const double missing = (highest - lowest) - (end - begin);
    const double shift = missing > 0      ? begin - lowest - missing / 2
                         : lowest < begin ? begin - lowest
                                          : std::min(0.0, end - highest);
    for (double& at : kind.at)
        at = std::clamp(at + shift, begin, end);
    return missing <= most_missing * kind.length.front();
}

/// Whether all margins keep their order and enough distance.
bool in_order(const std::vector<double>& margins, const std::vector<double>& before) {
    for (std::size_t i = 1; i < margins.size(); ++i)
        if (margins[i] - margins[i - 1] < least_distance * (before[i] - before[i - 1]))
            return false;
    return true;
}

/// The margins of one sequence, aligned; unchanged if they do not fit or do not stay in order.
std::vector<double> aligned(const Signal& signal, double begin, double end,
                            const Progress& progress, const std::vector<double>& margins) {
    if (margins.front() <= begin && margins.back() >= end)
        return margins; // a clip that was cut to whole cycles
    std::vector<double> result = margins;
    for (std::size_t from = 0; from < 2 && from + 2 < margins.size(); ++from) {
        Kind kind = kind_of(margins, from);
        for (int round = 0; round < most_rounds && move(signal, kind) > settled; ++round)
            progress.report(Stage::units, 1);
        if (!keep_inside(begin, end, kind))
            continue;
        for (std::size_t k = 0; k < kind.at.size(); ++k)
            result[from + 2 * k] = kind.at[k];
    }
    return in_order(result, margins) ? result : margins;
}

/// If two sequences met before or overlap now, gives them one margin between them.
void join(std::vector<double>& margins, std::vector<double>& next, bool met) {
    if (met || next.front() < margins.back())
        margins.back() = next.front() = (margins.back() + next.front()) / 2;
}

} // namespace

void align_margins(const Signal& signal, double begin, double end, const Progress& progress,
                   std::vector<CyclicStretch>& stretches) {
    std::vector<std::vector<double>*> sequences;
    for (CyclicStretch& cut : stretches)
        for (std::vector<double>& margins : cut.margins)
            sequences.push_back(&margins);
    std::vector<std::vector<double>> moved;
    for (const auto* margins : sequences)
        moved.push_back(aligned(signal, begin, end, progress, *margins));
    for (std::size_t i = 0; i + 1 < moved.size(); ++i)
        join(moved[i], moved[i + 1], sequences[i]->back() == sequences[i + 1]->front());
    for (std::size_t i = 0; i < moved.size(); ++i)
        *sequences[i] = std::move(moved[i]);
}

} // namespace stltsa::recording
