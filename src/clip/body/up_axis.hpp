// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// The up axis used: the requested one; y for AMC; else the axis nearest to the direction from the
/// feet to the head (joints by name), or, without these names, that of the body's largest extent.
Axis up_axis(const Clip& clip, std::optional<Axis> requested);

/// The axis along which v is largest; y if others are not larger.
Axis largest(const Vec3& v);

} // namespace stltsa::clip
