// SPDX-License-Identifier: BSD-3-Clause
// The part of a fit that does not depend on the number of coordinates.
#pragma once

#include <cstdint>
#include <span>

#include "base/progress.hpp"
#include "ltsa/frames.hpp"
#include "ltsa/neighbors/components.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/tangents/tangents.hpp"

namespace stltsa::ltsa {

/// Frames, neighborhoods, components and tangents of parameters.dimension dimensions.
struct Graph {
    DistinctFrames frames;
    Neighborhoods neighborhoods;
    Components components;
    Tangents tangents;
    Parameters parameters;
};

/// `frames` and `lengths` passed check_frames().
Graph build_graph(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                  const Parameters& parameters, const Progress& progress);

/// Directions in which some window of each component varies: no more coordinates can be embedded.
int varying_directions(const Graph& graph);

} // namespace stltsa::ltsa
