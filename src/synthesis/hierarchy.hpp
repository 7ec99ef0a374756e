// SPDX-License-Identifier: BSD-3-Clause
// Whether two clips show the same body.
#pragma once

#include <string>

#include "clip/clip.hpp"

namespace stltsa::synthesis {

/// Throws Status::unsupported where the clips differ in the names of joints, in what joint hangs on
/// what, in channels or, by more than 1 %, in offsets that no channels replace: the text says at
/// which joint. Returns the name of the joint whose offset differs most, within 1 %; "" where all
/// are the same.
std::string check_same_body(const clip::Clip& first, const clip::Clip& other,
                            const std::string& other_name);

} // namespace stltsa::synthesis
