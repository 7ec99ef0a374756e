// SPDX-License-Identifier: BSD-3-Clause
// The reasons and warnings of a decomposition. Times are those of the source.
#pragma once

#include <string>

#include "motion/activity.hpp"
#include "motion/decomposition.hpp"
#include "motion/embedding.hpp"

namespace stltsa::motion {

/// Time in seconds at which the neighborhood graph splits; no_time: it does not.
double break_time(const Embedding& embedding, const ltsa::Model& model, double fps, double first_s);
Warning parts_warning(const ltsa::Model& model, double break_s);

/// Reasons why there are no cycles.
std::string disconnected(const ltsa::Model& model, double break_s);
std::string no_period(const Activity& activity, double fps, const DecomposeOptions& options);

/// Warns about motions that were not searched for cycles on their own: any beside the cycles, or
/// several if there are no cycles.
void warn_about_motions(double fps, double first_s, Decomposition& result);

/// If there are no cycles, adds a jump or a drift that may be the cause to the reason. If there
/// are, warns about a jump.
void report_obstacles(ConstMatrixView samples, const DecomposeOptions& options,
                      Decomposition& result);

} // namespace stltsa::motion
