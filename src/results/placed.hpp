// SPDX-License-Identifier: BSD-3-Clause
// Maps rows of frames to coordinates, and rows of coordinates to frames or poses.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ltsa/mapping/mapping.hpp"
#include "results/fitted.hpp"

namespace stltsa::results {

/// How rows are mapped.
struct MapOptions {
    ltsa::MapParameters maps; ///< every field set (choose_map_parameters())
    int threads = 1;
};

/// The row of the model that a row is known to be near, or ltsa::no_hint.
using HintOf = std::function<std::int64_t(std::int64_t row)>;

/// The places of rows on the model.
struct Placed {
    std::vector<double> distance; ///< from the model, in units of the frames or the coordinates
    std::vector<std::int64_t> nearest; ///< row of the model
};

/// Writes the coordinates of each frame to `coords`.
Placed map_rows(const Fitted& fitted, const ltsa::Mapping& mapping, ConstMatrixView frames,
                const HintOf& hint_of, const MapOptions& options, MatrixView coords);

/// Writes the frame of each point: the features of its pose if the model has poses.
Placed unmap_frames(const Fitted& fitted, const ltsa::Mapping& mapping, ConstMatrixView coords,
                    std::int64_t component, const HintOf& hint_of, const MapOptions& options,
                    MatrixView frames);
/// Writes the pose vector of each point. The model has poses.
Placed unmap_poses(const Fitted& fitted, const ltsa::Mapping& mapping, ConstMatrixView coords,
                   std::int64_t component, const HintOf& hint_of, const MapOptions& options,
                   MatrixView vectors);

/// Features of every frame of a clip, computed as for the model. Throws if the clip does not match
/// the model.
Matrix clip_features(const Fitted& fitted, const clip::Clip& clip);

/// The row of the model that was fitted to this very frame of a clip with these features, or
/// ltsa::no_hint.
std::int64_t own_row(const Fitted& fitted, const Matrix& features, std::int64_t frame);

} // namespace stltsa::results
