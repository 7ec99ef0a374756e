// SPDX-License-Identifier: BSD-3-Clause
// How sure the answer is, as a share of right answers. The weights are measured: see
// measure/recordings.
#pragma once

#include <span>

#include "motion/cycles/stretch_cycles.hpp"

namespace stltsa::motion {

/// What is less sure is more probably wrong than right.
inline constexpr double min_confidence = 0.5;

/// Of each cycle of the stretch.
std::vector<double> cycle_confidences(const CyclicStretch& cut);

/// Of the cycle to the mean cycle: 1, the same, to 0, unrelated.
double likeness_of(const CyclicStretch& cut, const Interval& cycle);

double mean_of(std::span<const double> values); ///< 0: there are none

/// Of a border that saves so many times its price, between this number of single actions: in one
/// free motion behavior changes all the time.
double border_confidence(double gain, int actions);
/// The same of a border at a rest; `actions`: single ones beside the rest.
double rest_border_confidence(int actions);

/// Of one of several repetitions, by its mean unlikeness to the others.
double repetition_confidence(double unlikeness);

/// Of a single action: the longer it is, the more it consists of several.
double action_confidence(double seconds);

/// Of a rest: short ones may be part of a motion.
double rest_confidence(double seconds);

} // namespace stltsa::motion
