// SPDX-License-Identifier: BSD-3-Clause
// What the columns of features belong to.
#pragma once

#include <string>
#include <vector>

#include "clip/features/features.hpp"

namespace stltsa::clip {

/// For each column of the features the name of its joint or of the column of the file.
std::vector<std::string> column_owners(const Clip& clip, Features kind);

/// Weights of the columns whose sum over velocities tells which leg moves forward: of the joints
/// below the body root, those of one side less those of the other. Empty for features other than
/// positions, and if the body has no two sides there. The same sides in every clip of a skeleton.
std::vector<double> side_weights(const Clip& clip, Features kind, Axis up, ConstMatrixView samples);

} // namespace stltsa::clip
