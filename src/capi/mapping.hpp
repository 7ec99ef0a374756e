// SPDX-License-Identifier: BSD-3-Clause
// What a model needs besides its fit so that it can map.
#pragma once

#include <span>

#include "capi/handles.hpp"

namespace stltsa::capi {

/// What looks up frames and coordinates of the model; null where it kept no frames.
const ltsa::Mapping* mapping_of(const stltsa_model& model);

/// Keeps the poses of the clips that the model was fitted to, if they have a skeleton.
void keep_poses(stltsa_model& model, std::span<const stltsa_clip* const> clips);

/// A row of features: those of one pose vector, of the kind that the model was fitted to.
Matrix features_of_pose(const stltsa_model& model, ConstMatrixView vector);

} // namespace stltsa::capi
