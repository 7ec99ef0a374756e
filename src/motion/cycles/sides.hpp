// SPDX-License-Identifier: BSD-3-Clause
// Which side of the body does what in a cycle.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "motion/cycles/stretch_cycles.hpp"

namespace stltsa::motion {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// How fast the sides swing against each other at each row, relative to how fast the body usually
/// moves: the velocity, weighted as Options::side says, over `length`, the norm of these weights.
/// The mirror image has the negative.
std::vector<double> side_motion(const Signal& signal, ConstMatrixView samples,
                                const std::vector<double>& side, double length);

/// The side that comes forward where the cycles begin, 0 or 1.
int leading_side(const std::vector<double>& motion, std::span<const double> borders);

/// How cycles divide into steps.
struct Halves {
    double first = unknown;  ///< share of a cycle that the first step takes; NaN: there are none
    double margin = unknown; ///< half the width of its 95 % interval; NaN: not known
    std::string reason;      ///< why there are no steps
};

/// The first step ends where the other side does what the first does where the cycles begin. It is
/// half of a cycle unless the interval excludes that. Each side is compared with the other alone:
/// the difference of two equal sine waves is its own opposite after half a cycle, whatever the lag.
Halves halves_of(const Signal& signal, std::span<const Interval> cycles);

} // namespace stltsa::motion
