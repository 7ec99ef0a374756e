// SPDX-License-Identifier: BSD-3-Clause
// From results to the figure.
#pragma once

#include <string>

#include <stltsa.hpp>

#include "session.hpp"

namespace tool {

std::string decomposition_figure(const Session& session,
                                 const stltsa::Decomposition& decomposition);

/// Coordinate 1 over time, and the first two coordinates where there are as many.
std::string fit_figure(const Session& session, const stltsa::Model& model);

/// Each coordinate before and after, with the curve; `points`: before.
std::string denoising_figure(const Session& session, const stltsa::Matrix& points,
                             const stltsa::Denoising& denoising);

/// Postures across the seams of a new clip; of seams that are cut alike the first.
std::string synthesis_figure(const Arguments& arguments, const stltsa::Synthesis& synthesis);

} // namespace tool
