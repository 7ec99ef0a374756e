// SPDX-License-Identifier: BSD-3-Clause
// The repeating motions of a clip, on 0 to 100 % of the cycle.
#pragma once

#include <vector>

#include "base/json.hpp"
#include "report/body.hpp"
#include "results/phased.hpp"

namespace stltsa::report {

/// A list with an object for each label that has cycles or repetitions: their signals with mean and
/// standard deviation, their times, and left against right.
Json motions_json(const clip::Clip& clip, const results::Decomposed& decomposed,
                  const results::Phased& phased, const std::vector<Part>& parts,
                  const clip::PrepareOptions& prepare);

} // namespace stltsa::report
