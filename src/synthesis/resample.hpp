// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clip/clip.hpp"

namespace stltsa::synthesis {

/// Whether two frame rates are equal within the precision of a file's frame time.
bool same_rate(double a, double b);

/// The channel values of a clip at another frame rate: rotations by slerp, other channels linearly.
/// Frames that coincide with source frames keep their values.
Matrix resampled(const clip::Clip& clip, double fps);

} // namespace stltsa::synthesis
