// SPDX-License-Identifier: BSD-3-Clause
// Checks whether two clips show the same body.
#pragma once

#include <string>

#include "clip/clip.hpp"

namespace stltsa::synthesis {

/// Throws Status::unsupported if the clips differ in joint names, parents, channels or, by more
/// than 1 %, in offsets that no channels replace; the text names the joint. Returns the name of the
/// joint whose offset differs most, within 1 %; "" if all are equal.
std::string check_same_body(const clip::Clip& first, const clip::Clip& other,
                            const std::string& other_name);

} // namespace stltsa::synthesis
