// SPDX-License-Identifier: BSD-3-Clause
#include "plot/scale.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace tool::plot {

double nice_step(double length, int most) {
    const double least = length / most;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1 - 1e-9))
            return factor * power;
    return 10 * power;
}

std::vector<Tick> nice_ticks(double from, double to, int most) {
    const double step = nice_step(to - from, most);
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    std::vector<Tick> ticks;
    const double slack = 1e-9 * step;
    for (double i = std::ceil((from - slack) / step); i * step <= to + slack; ++i)
        ticks.push_back({i * step, fmt::format("{:.{}f}", i * step + 0.0, decimals)});
    return ticks;
}

} // namespace tool::plot
