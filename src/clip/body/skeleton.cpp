// SPDX-License-Identifier: BSD-3-Clause
#include "clip/body/skeleton.hpp"

#include <algorithm>
#include <cmath>

#include "clip/body/quaternion.hpp"

namespace stltsa::clip {

std::string_view channel_name(Channel channel) {
    constexpr std::string_view names[] = {"tx", "ty", "tz", "rx", "ry", "rz"};
    return names[static_cast<std::size_t>(channel)];
}

bool may_follow(Channel next, const std::vector<Channel>& channels) {
    constexpr std::size_t most = 6;
    return channels.size() < most &&
           (is_rotation(next) ||
            std::find(channels.begin(), channels.end(), next) == channels.end());
}

std::vector<std::string> channel_names(const Skeleton& skeleton) {
    std::vector<std::string> names;
    for (const Joint& joint : skeleton.joints)
        for (const Channel channel : joint.channels)
            names.push_back(format_text("{}.{}", joint.name, channel_name(channel)));
    return names;
}

std::int64_t channel_count(const Skeleton& skeleton) {
    std::size_t count = 0;
    for (const Joint& joint : skeleton.joints)
        count += joint.channels.size();
    return static_cast<std::int64_t>(count);
}

std::vector<std::size_t> channel_begins(const Skeleton& skeleton) {
    std::vector<std::size_t> begins;
    std::size_t next = 0;
    for (const Joint& joint : skeleton.joints) {
        begins.push_back(next);
        next += joint.channels.size();
    }
    return begins;
}

std::vector<std::size_t> turning_joints(const Skeleton& skeleton, std::size_t first) {
    std::vector<std::size_t> joints;
    for (std::size_t j = first; j < skeleton.joints.size(); ++j) {
        const std::vector<Channel>& channels = skeleton.joints[j].channels;
        if (std::any_of(channels.begin(), channels.end(), is_rotation))
            joints.push_back(j);
    }
    return joints;
}

bool same_hierarchy(const Skeleton& a, const Skeleton& b) {
    const auto same = [](const Joint& one, const Joint& other) {
        return one.name == other.name && one.parent == other.parent &&
               one.end_site == other.end_site && one.channels == other.channels &&
               one.adds == other.adds && std::abs(dot(one.axis, other.axis)) > 1 - 1e-9;
    };
    return a.fixed_axes == b.fixed_axes &&
           std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(), same);
}

} // namespace stltsa::clip
