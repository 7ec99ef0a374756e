// SPDX-License-Identifier: BSD-3-Clause
// Joints, channels and columns.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// "rx" and so on.
std::string_view channel_name(Channel channel);
inline bool is_rotation(Channel channel) {
    return channel >= Channel::rx;
}
/// 0, 1, 2 for x, y, z.
inline int channel_axis(Channel channel) {
    return static_cast<int>(channel) % 3;
}

/// Whether a joint may have one more channel. A rotation may come again, as in Z X Z; without a
/// limit memory would grow with the square of a hostile file.
bool may_follow(Channel next, const std::vector<Channel>& channels);
constexpr std::string_view channel_limit = "a joint has at most 6 channels, each position once";

/// "hip.rz" for every column of a skeleton's values.
std::vector<std::string> channel_names(const Skeleton& skeleton);
std::int64_t channel_count(const Skeleton& skeleton);

/// Where each joint's channels begin among the columns of a skeleton's values.
std::vector<std::size_t> channel_begins(const Skeleton& skeleton);

/// The joints from this one on that have rotation channels.
std::vector<std::size_t> turning_joints(const Skeleton& skeleton, std::size_t first);

} // namespace stltsa::clip
