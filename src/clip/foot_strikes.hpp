// SPDX-License-Identifier: BSD-3-Clause
// The foot strikes among the events of a file.
#pragma once

#include <vector>

#include "base/side_name.hpp"
#include "clip/clip.hpp"

namespace stltsa::clip {

struct FootStrike {
    double frame = 0; ///< see Event
    Side side = Side::neither;
};

/// In order of time. Names are those that Vicon, Qualisys, BTS and Visual3D write, such as Foot
/// Strike with the context Left, "R FS", RHS, eRHS and "Left Initial Contact".
std::vector<FootStrike> foot_strikes(const Clip& clip);

} // namespace stltsa::clip
