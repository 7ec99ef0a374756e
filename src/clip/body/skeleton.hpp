// SPDX-License-Identifier: BSD-3-Clause
// Joints, channels and columns.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// "tx" to "rz".
std::string_view channel_name(Channel channel);
inline bool is_rotation(Channel channel) {
    return channel >= Channel::rx;
}
/// 0, 1, 2 for x, y, z.
inline int channel_axis(Channel channel) {
    return static_cast<int>(channel) % 3;
}

/// Whether a joint may have one more channel. Rotations may repeat, as in Z X Z; the limit keeps
/// the memory for a hostile file from growing with the square of its size.
bool may_follow(Channel next, const std::vector<Channel>& channels);
constexpr std::string_view channel_limit = "a joint has at most 6 channels, each position once";

/// "hip.rz" for every column of a skeleton's values.
std::vector<std::string> channel_names(const Skeleton& skeleton);
std::int64_t channel_count(const Skeleton& skeleton);

/// The column of each joint's first channel.
std::vector<std::size_t> channel_begins(const Skeleton& skeleton);

/// The joints with rotation channels, starting from `first`.
std::vector<std::size_t> turning_joints(const Skeleton& skeleton, std::size_t first);

/// Whether both skeletons have the same joints, parents and channels, so that frames of one are
/// valid for the other. Offsets may differ.
bool same_hierarchy(const Skeleton& a, const Skeleton& b);

} // namespace stltsa::clip
