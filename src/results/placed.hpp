// SPDX-License-Identifier: BSD-3-Clause
// Rows of frames or coordinates found on a model, and what they become there.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/progress.hpp"
#include "ltsa/mapping/mapping.hpp"
#include "results/fitted.hpp"

namespace stltsa::results {

/// How rows are placed on a model.
struct MapOptions {
    ltsa::MapParameters maps; ///< every field set (choose_map_parameters())
    int threads = 1;
    Progress progress;
};

/// The row of the model that a row is known to be near, or ltsa::no_hint.
using HintOf = std::function<std::int64_t(std::int64_t row)>;

/// Where rows lie on the model.
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

/// Features of every frame of a clip as the model's were made. Throws for a clip that does not go
/// with the model.
Matrix clip_features(const Fitted& fitted, const clip::Clip& clip);

/// The row of the model that was fitted to this very frame of a clip with these features, or
/// ltsa::no_hint.
std::int64_t own_row(const Fitted& fitted, const Matrix& features, std::int64_t frame);

} // namespace stltsa::results
