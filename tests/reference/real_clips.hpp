// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "neighbors.hpp"

namespace reference {

/// Whether `folder` contains the clips below.
bool has_real_clips(const std::string& folder);

/// The first `count` frames of the CMU clips 13_29, 13_30 and 86_01, one after another, as joint
/// angles at 120 frames per second: one connected motion.
Frames real_chain(const std::string& folder, std::size_t count);

} // namespace reference
