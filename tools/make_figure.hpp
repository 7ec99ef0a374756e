// SPDX-License-Identifier: BSD-3-Clause
// From results to the figure.
#pragma once

#include <string>

#include "session.hpp"

namespace tool {

std::string decomposition_figure(const Session& session, const Json& object,
                                 const stltsa_decomposition* decomposition);

/// Coordinate 1 over time, and the first two coordinates where there are as many.
std::string fit_figure(const Session& session, const Json& object, const stltsa_model* model,
                       const Grid& coords);

/// Each coordinate before and after, with the curve; `points`: before.
std::string denoising_figure(const Json& object, const Grid& points,
                             const stltsa_denoising* denoising);

/// Postures across the seams of a new clip; of seams that are cut alike the first.
std::string synthesis_figure(const Json& object, const Arguments& arguments,
                             const stltsa_clip* clip);

} // namespace tool
