// SPDX-License-Identifier: BSD-3-Clause
#include "recording/sides.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"

namespace stltsa::recording {
namespace {

constexpr std::size_t margins_of_a_cycle = 3;
/// Fewer margins, of one or two cycles, are kept whichever half comes first.
constexpr std::size_t most_kept = 6;
constexpr double clear_rise = 0.05;
/// Correlation of the sides' motion with itself half a cycle later, below which they alternate.
constexpr double alternating = -0.6;
/// Share of the speed of the samples along the weights of the sides, below which the sides do not
/// move: 0.25 and more in walks and runs, at most 0.2 in waves and claps.
constexpr double least_share = 0.22;

double at(const std::vector<double>& motion, double row) {
    double value = 0;
    row_at({motion.data(), static_cast<std::int64_t>(motion.size()), 1, 1}, row, &value);
    return value;
}

/// Mean motion at every second margin from the first, less that at the others.
double preference(const std::vector<double>& motion, const std::vector<double>& margins) {
    double sums[2] = {}, counts[2] = {};
    for (std::size_t i = 0; i < margins.size(); ++i) {
        sums[i % 2] += at(motion, margins[i]);
        counts[i % 2] += 1;
    }
    return sums[0] / counts[0] - sums[1] / counts[1];
}

/// How much more the columns rise at every second margin from the first than at the others, -1 to
/// 1. Near 0 if columns mirror each other: then either half may come first.
double rise(const Signal& signal, const std::vector<double>& margins) {
    std::vector<double> velocity(static_cast<std::size_t>(signal.cols())), difference = velocity;
    const auto count = static_cast<double>(margins.size());
    for (std::size_t i = 0; i < margins.size(); ++i) {
        row_at(signal.velocity.view(), margins[i], velocity.data());
        const double of_kind = i % 2 == 0 ? std::ceil(count / 2) : -std::floor(count / 2);
        axpy(1 / of_kind, velocity.data(), difference.data(), signal.cols());
    }
    double sum = 0, size = 0;
    for (std::int64_t c = 0; c < signal.directions.rows(); ++c) {
        const double d = dot(difference.data(), signal.directions.row(c), signal.cols());
        sum += d * std::abs(d);
        size += d * d;
    }
    return size > 0 ? sum / size : 0;
}

void append_cycles(const std::vector<double>& margins, std::vector<Interval>& cycles) {
    for (std::size_t i = 0; i + 2 < margins.size(); i += 2)
        cycles.push_back({margins[i], margins[i + 2]});
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

std::vector<int> sides_of(const std::vector<double>& motion, const CyclicStretch& cut) {
    std::vector<int> sides;
    for (const std::vector<double>& margins : cut.margins) {
        const std::size_t cycles = margins.empty() ? 0 : (margins.size() - 1) / 2;
        sides.insert(sides.end(), cycles, preference(motion, margins) < 0 ? 0 : 1);
    }
    return sides;
}

std::vector<int> turn_to_side(const std::vector<double>& motion, CyclicStretch& cut) {
    std::vector<int> sides;
    cut.cycles.clear();
    for (std::vector<double>& margins : cut.margins) {
        bool first = preference(motion, margins) < 0;
        if (!first && margins.size() > margins_of_a_cycle) {
            margins.erase(margins.begin());
            first = true;
        }
        append_cycles(margins, cut.cycles);
        sides.resize(cut.cycles.size(), first ? 0 : 1);
    }
    return sides;
}

void turn_to_rise(const Signal& signal, CyclicStretch& cut) {
    cut.cycles.clear();
    for (std::vector<double>& margins : cut.margins) {
        const bool loses_one_of_few = margins.size() % 2 == 1 && margins.size() < most_kept;
        if (!loses_one_of_few && rise(signal, margins) < -clear_rise)
            margins.erase(margins.begin());
        append_cycles(margins, cut.cycles);
    }
}

bool sides_alternate(const std::vector<double>& motion, const CyclicStretch& cut) {
    constexpr int phases = 12;
    double both = 0, energy = 0, count = 0;
    for (const Interval& cycle : cut.cycles)
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

} // namespace stltsa::recording
