// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/sides.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/gaussian.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/extrema.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// Correlation of the sides' motion with itself half a cycle later, below which they alternate.
constexpr double alternating = -0.6;
/// Share of the speed of the samples along the weights of the sides, below which the sides do not
/// move: 0.25 and more in walks and runs, at most 0.2 in waves and claps.
constexpr double least_share = 0.22;
/// The halves of a cycle are compared this far to each side of their begin, and the second begins
/// this far from the middle at most. Over a whole cycle the mirror image of the mirror image is the
/// same body, so that every cycle would seem to have equal halves.
constexpr double compared_share = 0.15;
constexpr double max_off_middle = 0.15;
/// Interpolation between rows alone moves the middle by less than this share of a cycle.
constexpr double resolution = 0.002;
/// Fewer cycles have no interval that is worth stating.
constexpr std::size_t min_cycles = 3;
/// Seconds at the ends of the recording in which smoothing bends velocities.
constexpr double bent_s = 0.15;
constexpr double smoothing_s = 0.04;

/// Cubic between the rows (Catmull, Rom): linear values are off by a tenth in fast parts of a step.
double at(const std::vector<double>& motion, double row) {
    const auto last = static_cast<std::int64_t>(motion.size()) - 1;
    const double inside = std::clamp(row, 0.0, static_cast<double>(last));
    const auto i = static_cast<std::int64_t>(inside);
    const double x = inside - static_cast<double>(i);
    const auto value = [&](std::int64_t k) {
        return motion[static_cast<std::size_t>(std::clamp<std::int64_t>(k, 0, last))];
    };
    const double a = value(i - 1), b = value(i), c = value(i + 1), d = value(i + 2);
    return b + x * ((c - a) + x * ((2 * a - 5 * b + 4 * c - d) + x * (3 * (b - c) + d - a))) / 2;
}

/// Whether each side does in one half of the cycles what the other does in the next.
bool sides_alternate(const std::vector<double>& motion, std::span<const Interval> cycles) {
    constexpr int phases = 12;
    double both = 0, energy = 0, count = 0;
    for (const Interval& cycle : cycles)
        for (int p = 0; p < phases; ++p) {
            const double step = cycle.length() / (2 * phases);
            const double a = at(motion, cycle.begin + p * step);
            const double b = at(motion, cycle.begin + (p + phases) * step);
            both += a * b;
            energy += (a * a + b * b) / 2;
            ++count;
        }
    return energy > least_share * least_share * count && both < alternating * energy;
}

/// How each of two sides moves: the one with which cycles begin, and the other.
struct Swing {
    std::vector<double> first, second;
};

Swing swing_of(const Signal& signal, int side) {
    Swing swing; // absolute: the usual speed may change within a cycle
    for (std::size_t i = 0; i < signal.side.size(); ++i) {
        swing.first.push_back(signal.one_side[i] * signal.usual[i]);
        swing.second.push_back(signal.other_side[i] * signal.usual[i]);
    }
    if ((side == 1) != *signal.forward)
        swing.first.swap(swing.second);
    return swing;
}

/// The share of a cycle after which the second side moves as the first does around its begin.
double first_half(const Swing& swing, double bent, std::span<const Interval> cycles) {
    constexpr int places = 15, steps = 30;
    const double last = static_cast<double>(swing.first.size() - 1) - bent;
    const auto likeness = [&](int step) { // negative mean squared difference of both halves
        const double half = 0.5 + max_off_middle * step / steps;
        double sum = 0, count = 0;
        for (const Interval& cycle : cycles)
            for (int p = -places; p <= places; ++p) {
                const double first = cycle.begin + compared_share * p / places * cycle.length();
                const double second = first + half * cycle.length();
                if (first < bent || second > last)
                    continue;
                const double off = at(swing.first, first) - at(swing.second, second);
                sum += off * off;
                ++count;
            }
        return count > 0 ? -sum / count : 0;
    };
    int best = 0;
    for (int step = -steps; step <= steps; ++step)
        if (likeness(step) > likeness(best))
            best = step;
    const double step =
        best + parabola_vertex(likeness(best - 1), likeness(best), likeness(best + 1));
    return 0.5 + max_off_middle * step / steps;
}

/// Half the width of the 95 % confidence interval of the mean.
double margin_of(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    return t_quantile(count - 1) * standard_deviation(values) / std::sqrt(count);
}

} // namespace

std::vector<double> side_motion(const Signal& signal, ConstMatrixView samples,
                                const std::vector<double>& side, double length) {
    Matrix swing(signal.rows(), 1);
    for (std::int64_t i = 0; i < signal.rows(); ++i)
        swing(i, 0) = dot(samples.row(i * signal.step), side.data(), samples.cols);
    const Matrix smooth =
        gaussian_smoothed(swing.view(), smoothing_s * signal.rate, Beyond::reflection);
    std::vector<double> motion;
    for (std::int64_t i = 0; i < signal.rows(); ++i) {
        const std::int64_t before = std::max<std::int64_t>(0, i - 1);
        const std::int64_t after = std::min(i + 1, signal.rows() - 1);
        const double scale = length * signal.usual[static_cast<std::size_t>(i)];
        motion.push_back(scale > 0 ? (smooth(after, 0) - smooth(before, 0)) /
                                         (scale * static_cast<double>(after - before))
                                   : 0);
    }
    return motion;
}

double fixed_weight(std::size_t column) {
    constexpr double golden_angle = 2.399963229728653;
    return std::cos(golden_angle * static_cast<double>(column));
}

int leading_side(const std::vector<double>& motion, std::span<const double> borders) {
    double sum = 0;
    for (const double border : borders)
        sum += at(motion, border);
    return sum < 0 ? 0 : 1;
}

Halves halves_of(const Signal& signal, std::span<const Interval> cycles, int side) {
    if (signal.side.empty())
        return {none, none,
                "the two sides of the body are not known: they are those of a skeleton, or of "
                "points with names such as LHEE and RHEE"};
    if (!sides_alternate(signal.side, cycles))
        return {none, none, "the two sides of the body do not swing in turn"};
    const double bent = 1 + bent_s * signal.rate;
    if (cycles.size() < min_cycles || !signal.forward)
        return {0.5, none, {}};
    std::vector<double> begins;
    for (const Interval& cycle : cycles)
        begins.push_back(cycle.begin);
    const Swing swing = swing_of(signal, side >= 0 ? side : leading_side(signal.side, begins));
    std::vector<double> each;
    for (std::size_t i = 0; i < cycles.size(); ++i)
        each.push_back(first_half(swing, bent, cycles.subspan(i, 1)));
    const double all = first_half(swing, bent, cycles), margin = margin_of(each);
    return {std::abs(all - 0.5) > std::max(margin, resolution) ? all : 0.5, margin, {}};
}

Halves halves_at(std::span<const double> middles, std::span<const Interval> cycles) {
    std::vector<double> shares;
    double sum = 0;
    for (std::size_t i = 0; i < cycles.size(); ++i)
        sum += shares.emplace_back((middles[i] - cycles[i].begin) / cycles[i].length());
    return {sum / static_cast<double>(shares.size()),
            shares.size() < min_cycles ? none : margin_of(shares),
            {}};
}

} // namespace stltsa::motion
