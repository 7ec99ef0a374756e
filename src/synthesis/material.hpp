// SPDX-License-Identifier: BSD-3-Clause
// Input of a synthesis: the clips with one body and one frame rate.
#pragma once

#include <string>
#include <vector>

#include "synthesis/plan.hpp"
#include "synthesis/synthesis.hpp"

namespace stltsa::synthesis {

struct Material {
    Body body;
    clip::Axis up;
    std::vector<Track> tracks; ///< one per clip
    std::vector<Part> parts;   ///< one per piece
    Warnings warnings;
};

/// Checks the pieces (at least one) and makes their tracks.
Material prepare_material(std::span<const Piece> pieces, std::optional<clip::Axis> up);

/// The synthesis of this material, of which `first` is the first piece's clip.
Synthesis synthesize(const Material& material, const clip::Clip& first, const Options& options);

} // namespace stltsa::synthesis
