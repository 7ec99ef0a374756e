// SPDX-License-Identifier: BSD-3-Clause
#include "recording/sides.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"
#include "motion/curve/extrema.hpp"

namespace stltsa::recording {
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

double at(const std::vector<double>& motion, double row) {
    double value = 0;
    row_at({motion.data(), static_cast<std::int64_t>(motion.size()), 1, 1}, row, &value);
    return value;
}

} // namespace

std::vector<double> side_motion(const Signal& signal, const std::vector<double>& side) {
    std::vector<double> weights(static_cast<std::size_t>(signal.cols()));
    for (std::size_t c = 0; c < side.size(); ++c)
        axpy(side[c], signal.directions.row(static_cast<std::int64_t>(c)), weights.data(),
             signal.cols());
    const double length = std::sqrt(dot(weights.data(), weights.data(), signal.cols()));
    std::vector<double> motion;
    for (std::int64_t i = 0; i < signal.rows(); ++i) {
        const double scale = length * signal.usual[static_cast<std::size_t>(i)];
        motion.push_back(
            scale > 0 ? dot(signal.velocity.row(i), weights.data(), signal.cols()) / scale : 0);
    }
    return motion;
}

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

int leading_side(const std::vector<double>& motion, std::span<const double> borders) {
    double sum = 0;
    for (const double border : borders)
        sum += at(motion, border);
    return sum < 0 ? 0 : 1;
}

double middle_of(const std::vector<double>& motion, const Interval& cycle) {
    constexpr int places = 15, steps = 30;
    const auto difference = [&](int step) {
        const double half = 0.5 + max_off_middle * step / steps;
        double sum = 0, count = 0;
        for (int p = -places; p <= places; ++p) {
            const double first = cycle.begin + compared_share * p / places * cycle.length();
            const double second = first + half * cycle.length();
            if (first < 0 || second > static_cast<double>(motion.size() - 1))
                continue;
            const double both = at(motion, first) + at(motion, second);
            sum += both * both;
            ++count;
        }
        return count > 0 ? -sum / count : 0;
    };
    int best = 0;
    for (int step = -steps; step <= steps; ++step)
        if (difference(step) > difference(best))
            best = step;
    const double step = best + motion::parabola_vertex(difference(best - 1), difference(best),
                                                       difference(best + 1));
    return cycle.begin + (0.5 + max_off_middle * step / steps) * cycle.length();
}

} // namespace stltsa::recording
