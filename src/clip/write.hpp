// SPDX-License-Identifier: BSD-3-Clause
// Writes clips to files.
#pragma once

#include <string>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Writes the clip in the format of the suffix, completely or not at all.
void write(const Clip& clip, const std::string& path);

} // namespace stltsa::clip
