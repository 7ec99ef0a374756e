// SPDX-License-Identifier: BSD-3-Clause
// Which side of the body does what in a cycle.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/numbers.hpp"
#include "motion/cycles/stretch_cycles.hpp"

namespace stltsa::motion {

/// How fast the sides swing against each other at each row, relative to how fast the body usually
/// moves: the velocity, weighted as Options::side says, over `length`, the norm of these weights.
/// The mirror image has the negative.
std::vector<double> side_motion(const Signal& signal, ConstMatrixView samples,
                                const std::vector<double>& side, double length);

/// Weight of a column of a body without known sides: any weights do that are the same in every
/// recording and do not cancel. By the golden angle, no few columns have like weights.
double fixed_weight(std::size_t column);

/// The side that comes forward where the cycles begin, 0 or 1.
int leading_side(const std::vector<double>& motion, std::span<const double> borders);

/// How cycles divide into steps.
struct Halves {
    double first = none;  ///< share of a cycle that the first step takes; NaN: there are none
    double margin = none; ///< half the width of its 95 % interval; NaN: not known
    std::string reason;   ///< why there are no steps
};

/// The first step ends where the other side does what the first does where the cycles begin. It is
/// half of a cycle unless the interval excludes that. Each side is compared with the other alone:
/// the difference of two equal sine waves is its own opposite after half a cycle, whatever the lag.
/// `side`: with which cycles begin; -1: the one that comes forward there.
Halves halves_of(const Signal& signal, std::span<const Interval> cycles, int side = -1);

/// The same where it is known when the first step of each cycle ends.
Halves halves_at(std::span<const double> middles, std::span<const Interval> cycles);

} // namespace stltsa::motion
