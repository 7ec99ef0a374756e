// SPDX-License-Identifier: BSD-3-Clause
// From results to figures.
#pragma once

#include <string>

#include <stltsa.hpp>

#include "commands/session.hpp"

namespace tool {

std::string decomposition_figure(const Session& session,
                                 const stltsa::Decomposition& decomposition);

/// Coordinate 1 over time and, if there are two, the first two coordinates as a loop.
std::string fit_figure(const Session& session, const stltsa::Model& model);

/// Each coordinate before (`points`) and after, with the fitted curve.
std::string denoising_figure(const Session& session, const stltsa::Matrix& points,
                             const stltsa::Denoising& denoising);

/// Postures across the seams of a new clip; identical seams are shown once.
std::string synthesis_figure(const std::string& title, const std::vector<std::string>& pieces,
                             const stltsa::Synthesis& synthesis);

} // namespace tool
