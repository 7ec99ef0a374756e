// SPDX-License-Identifier: BSD-3-Clause
// What a decomposition says about itself in words: reasons and warnings, with times of the source.
#pragma once

#include <string>

#include "motion/activity.hpp"
#include "motion/decompose.hpp"
#include "motion/embedding.hpp"

namespace stltsa::motion {

/// When the model's curve falls apart, in seconds; no_time: it does not.
double cut_time(const Embedding& embedding, const ltsa::Model& model, double fps, double first_s);
Warning parts_warning(const ltsa::Model& model, double cut_s);

/// Reasons for no cycles.
std::string fell_apart(const ltsa::Model& model, double cut_s);
std::string no_period(const Activity& activity, double fps, const DecomposeOptions& options);

/// Says of motions that no cycle was looked for in them alone: those beside the cycles, or several
/// where there are no cycles.
void warn_of_motions(double fps, double first_s, Decomposition& result);

/// What may hide that the motion repeats itself: a jump, worth a warning in any case, or a drift.
void tell_obstacles(ConstMatrixView samples, const DecomposeOptions& options,
                    Decomposition& result);

} // namespace stltsa::motion
