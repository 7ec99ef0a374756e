// SPDX-License-Identifier: BSD-3-Clause
// The frames of a clip that a stretch names: some kinds need the clip's decomposition.
#pragma once

#include <functional>
#include <vector>

#include "clip/stretch.hpp"
#include "results/decomposed.hpp"

namespace stltsa::results {

/// `decomposed` is called if it is needed. Segments of a label are given in order, all others are
/// one stretch: of a kind of unit, the longest. Throws Status::no_such_part.
std::vector<clip::Frames> find_stretches(const clip::Clip& clip, const clip::Stretch& stretch,
                                         const std::function<Decomposed()>& decomposed);

} // namespace stltsa::results
