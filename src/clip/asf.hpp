// SPDX-License-Identifier: BSD-3-Clause
// Acclaim skeleton files. A bone's rotation acts at its parent end and turns the bone itself, so a
// bone becomes a joint that sits at the end of its parent bone; the end of a bone without
// children becomes an end site.
#pragma once

#include <string>
#include <string_view>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// AMC files carry no frame rate. The CMU database, where most of them come from, was captured at
/// this one.
constexpr double amc_fps = 120;

struct AsfFile {
    Skeleton skeleton; ///< joint 0 is the root, the others are named as their bones
    bool degrees = true;
};

AsfFile parse_asf(std::string_view bytes, const std::string& name);

} // namespace stltsa::clip
