// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/machine.hpp"
#include "ltsa/neighbors/neighbors.hpp"

namespace stltsa::ltsa {

/// The connected components of the graph in which all frames of a neighborhood are connected. The
/// alignment matrix has one zero eigenvalue for each, so each is embedded separately.
struct Components {
    std::int64_t count = 0;
    UnsetVector<std::int32_t> of_frame;             ///< numbered by first frame
    std::vector<UnsetVector<std::int32_t>> members; ///< ascending
    UnsetVector<std::int32_t> position;             ///< of each frame within its component
    /// Frames whose neighborhoods lie in a component, ascending: its members, except that a frame
    /// outside its own neighborhood may be in another component.
    std::vector<UnsetVector<std::int32_t>> windows;
};

Components connected_components(const Neighborhoods& neighborhoods, const Machine& machine);

} // namespace stltsa::ltsa
