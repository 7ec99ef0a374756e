// SPDX-License-Identifier: BSD-3-Clause
// The motions of a clip that repeat, on 0 to 100 % of the cycle.
#pragma once

#include <vector>

#include "base/json.hpp"
#include "base/progress.hpp"
#include "report/body.hpp"
#include "results/phased.hpp"

namespace stltsa::report {

/// A list with an object for each label that has cycles or repetitions: signals of its cycles with
/// mean and spread, times, and left against right.
Json motions_json(const clip::Clip& clip, const results::Decomposed& decomposed,
                  const results::Phased& phased, const std::vector<Part>& parts,
                  const clip::PrepareOptions& prepare, const Progress& progress);

} // namespace stltsa::report
