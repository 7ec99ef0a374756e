// SPDX-License-Identifier: BSD-3-Clause
#include "clip/formats.hpp"

namespace stltsa::clip {

std::string_view channel_name(Channel channel) {
    constexpr std::string_view names[] = {"tx", "ty", "tz", "rx", "ry", "rz"};
    return names[static_cast<std::size_t>(channel)];
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

} // namespace stltsa::clip
