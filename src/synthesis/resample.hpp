// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clip/clip.hpp"

namespace stltsa::synthesis {

/// Whether two frame rates are one, but for the digits of the frame time in a file.
bool same_rate(double a, double b);

/// The channel values of a clip at another frame rate: rotations by slerp, the rest linear. Frames
/// that fall on source frames are those.
Matrix resampled(const clip::Clip& clip, double fps);

} // namespace stltsa::synthesis
