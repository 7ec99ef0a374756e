// SPDX-License-Identifier: BSD-3-Clause
#include "recording/sides.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"

namespace stltsa::recording {
namespace {

constexpr std::size_t margins_of_a_cycle = 3;
/// Correlation of the sides' motion with itself half a cycle later, below which they alternate.
constexpr double alternating = -0.6;

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

} // namespace

std::vector<double> side_motion(const Signal& signal, const std::vector<double>& side) {
    std::vector<double> weights(static_cast<std::size_t>(signal.cols()));
    for (std::size_t c = 0; c < side.size(); ++c)
        axpy(side[c], signal.directions.row(static_cast<std::int64_t>(c)), weights.data(),
             signal.cols());
    std::vector<double> motion;
    for (std::int64_t i = 0; i < signal.rows(); ++i)
        motion.push_back(dot(signal.velocity.row(i), weights.data(), signal.cols()));
    return motion;
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
        for (std::size_t i = 0; i + 2 < margins.size(); i += 2) {
            cut.cycles.push_back({margins[i], margins[i + 2]});
            sides.push_back(first ? 0 : 1);
        }
    }
    return sides;
}

bool sides_alternate(const std::vector<double>& motion, const CyclicStretch& cut) {
    constexpr int phases = 12;
    double both = 0, energy = 0;
    for (const Interval& cycle : cut.cycles)
        for (int p = 0; p < phases; ++p) {
            const double step = cycle.length() / (2 * phases);
            const double a = at(motion, cycle.begin + p * step);
            const double b = at(motion, cycle.begin + (p + phases) * step);
            both += a * b;
            energy += (a * a + b * b) / 2;
        }
    return energy > 0 && both < alternating * energy;
}

} // namespace stltsa::recording
