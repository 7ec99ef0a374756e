// SPDX-License-Identifier: BSD-3-Clause
// The readers of single formats, and what they share.
#pragma once

#include <string>
#include <string_view>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// AMC files carry no frame rate. The CMU database, where most of them come from, was captured at
/// this one.
constexpr double amc_fps = 120;

/// The ASF file that belongs to an AMC file, looked for in the same folder.
std::string find_skeleton(const std::string& amc_path);

// Each gets the file's bytes and the name to use in messages. They set all of Clip but path and
// format; fps is the file's own, 0 where it has none.
Clip parse_bvh(std::string_view bytes, const std::string& name);
Clip parse_amc(std::string_view bytes, const std::string& name, const ReadOptions& options);
Clip parse_csv(std::string_view bytes, const std::string& name, const ReadOptions& options);
Clip parse_npy(std::string_view bytes, const std::string& name);

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
