// SPDX-License-Identifier: BSD-3-Clause
// The part of a fit that does not depend on the number of coordinates:
// Table 1, step 1; Table 1, step 2; Table 1, step 3.
#pragma once

#include <cstdint>
#include <span>

#include "ltsa/frames.hpp"
#include "ltsa/neighbors/components.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/tangents/tangents.hpp"

namespace stltsa::ltsa {

/// Distinct frames, their neighborhoods and components, and parameters.dimension tangents of each.
struct Graph {
    DistinctFrames frames;
    Neighborhoods neighborhoods;
    Components components;
    Tangents tangents;
    Parameters parameters;
};

/// `frames` and `lengths` have passed check_frames().
Graph build_graph(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                  const Parameters& parameters);

/// The largest number of coordinates that can be embedded: in every component, some window varies
/// in so many directions.
int varying_directions(const Graph& graph);

} // namespace stltsa::ltsa
