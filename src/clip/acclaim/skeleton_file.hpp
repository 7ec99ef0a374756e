// SPDX-License-Identifier: BSD-3-Clause
// Acclaim skeleton files. A bone rotates about the end of its parent bone, so each bone becomes a
// joint at the end of its parent bone; the end of a bone without children becomes an end site.
#pragma once

#include <string>
#include <string_view>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// AMC files have no frame rate. This is the rate of the CMU database, the source of most of them.
constexpr double amc_fps = 120;

struct AsfFile {
    Skeleton skeleton; ///< joint 0 is the root, the others have the names of their bones
    bool degrees = true;
};

AsfFile parse_asf(std::string_view bytes, const std::string& name);

} // namespace stltsa::clip
