// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "clip/body/up_axis.hpp"

namespace stltsa::clip {

/// The mirror image: what was done by the left side is done by the right one. Each joint or point
/// takes the place of its partner, which has its name with the sides exchanged, reflected across
/// the middle of the body; others are their own partners. Names and their order stay. Throws
/// Status::unsupported if no name has a partner, or if the two sides of the skeleton differ in
/// their hierarchy.
Clip mirrored(const Clip& clip, std::optional<Axis> up);

} // namespace stltsa::clip
