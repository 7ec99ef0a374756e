// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "clip/clip.hpp"

namespace stltsa::clip {

enum class Axis : std::int32_t { automatic = 0, x = 1, y = 2, z = 3 };

/// The up axis used: the given one; y for AMC; else that along which the head lies from the feet
/// over the clip (joints by name), or the body is largest where these names are missing.
Axis up_axis(const Clip& clip, Axis requested);

} // namespace stltsa::clip
