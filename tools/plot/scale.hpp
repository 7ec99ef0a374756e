// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tool::plot {

/// From values to positions in the figure.
struct Scale {
    double from = 0; ///< value at `start`
    double to = 1;   ///< value at `end`
    double start = 0;
    double end = 1;

    double operator()(double value) const {
        return start + (value - from) / (to - from) * (end - start);
    }
};

/// The smallest 1, 2 or 5 times a power of ten such that at most `most` steps fill `length`.
double nice_step(double length, int most);

struct Tick {
    double value = 0;
    std::string label;
};
/// Multiples of a nice step within [from, to], with the step's number of decimals.
std::vector<Tick> nice_ticks(double from, double to, int most);

} // namespace tool::plot
