// SPDX-License-Identifier: BSD-3-Clause
// Which side of the body does what in a cycle.
#pragma once

#include <span>
#include <vector>

#include "motion/cycles/stretch_cycles.hpp"

namespace stltsa::motion {

/// How fast the sides swing against each other at each row, relative to how fast the body usually
/// moves: the velocity, weighted as Options::side says. The mirror image has the negative.
std::vector<double> side_motion(const Signal& signal, ConstMatrixView samples,
                                const std::vector<double>& side);

/// Whether each side does in one half of the cycles what the other does in the next.
bool sides_alternate(const std::vector<double>& motion, std::span<const Interval> cycles);

/// The side that comes forward where the cycles begin, 0 or 1.
int leading_side(const std::vector<double>& motion, std::span<const double> borders);

/// Share of the cycles after which the other side does what the first does where they begin.
double first_half_of(const Signal& signal, std::span<const Interval> cycles);

} // namespace stltsa::motion
