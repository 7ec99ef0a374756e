// SPDX-License-Identifier: BSD-3-Clause
// The figure of a decomposition: the curve over time with units, cycles and postures, the loop, and
// the cycles on 0 to 100 %. docs/report.md shows it.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "results/decomposed.hpp"

namespace stltsa::report {

/// An SVG document. Throws Status::argument if the decomposition is not of the clip.
std::string figure(const clip::Clip& clip, const results::Decomposed& found,
                   const std::string& title);

} // namespace stltsa::report
