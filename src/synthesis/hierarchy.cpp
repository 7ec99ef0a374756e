// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/hierarchy.hpp"

#include <algorithm>

#include "clip/body/heading.hpp"
#include "clip/body/quaternion.hpp"
#include "clip/body/skeleton.hpp"

namespace stltsa::synthesis {
namespace {

using clip::Joint;
using clip::Skeleton;

/// Allowed relative difference of an offset, and the share of the longest offset that counts as
/// rounding in a file with few digits.
constexpr double tolerance = 0.01;
constexpr double rounding = 1e-4;

constexpr const char* advice =
    "; only clips recorded with, or retargeted to, the same skeleton can be joined";

double longest_offset(const Skeleton& skeleton) {
    double longest = 0;
    for (const Joint& joint : skeleton.joints)
        longest = std::max(longest, clip::norm(joint.offset));
    return longest;
}

bool same_axis(const clip::Quaternion& a, const clip::Quaternion& b) {
    return std::abs(dot(a, b)) > 1 - 1e-9;
}

void check_joint(const Joint& a, const Joint& b, std::size_t index, const std::string& name) {
    if (a.name != b.name || a.end_site != b.end_site)
        fail(Status::unsupported, "{} has the joint \"{}\" where the first clip has \"{}\"{}", name,
             b.name, a.name, advice);
    if (a.parent != b.parent)
        fail(Status::unsupported,
             "joint {} (\"{}\") of {} has a different parent than in the first clip{}", index,
             b.name, name, advice);
    if (a.channels != b.channels || a.adds != b.adds || !same_axis(a.axis, b.axis))
        fail(Status::unsupported,
             "joint \"{}\" of {} has different channels than in the first clip{}", b.name, name,
             advice);
}

/// Whether position channels replace the joint's offset, which then says nothing about the body:
/// true for the root, and for hips that travel below a static root.
bool is_placed(const Joint& joint, std::size_t j, std::size_t body_root) {
    const std::vector<clip::Channel>& channels = joint.channels;
    const auto rotations = std::count_if(channels.begin(), channels.end(), clip::is_rotation);
    const bool replaced = !joint.adds && std::ssize(channels) - rotations == 3;
    return j == 0 ? !channels.empty() : j <= body_root && replaced;
}

/// Difference in units of the tolerance; above 1 the bodies differ.
double offset_difference(const Joint& first, const Joint& other, double longest) {
    const double length = std::max(clip::norm(first.offset), clip::norm(other.offset));
    const double allowed = std::max(tolerance * length, rounding * longest);
    return allowed > 0 ? clip::norm(clip::operator-(first.offset, other.offset)) / allowed : 0;
}

} // namespace

std::string check_same_body(const clip::Clip& first, const clip::Clip& other,
                            const std::string& name) {
    const Skeleton& a = *first.skeleton;
    const Skeleton& b = *other.skeleton;
    if (a.joints.size() != b.joints.size())
        fail(Status::unsupported, "{} has {} joints, the first clip has {}{}", name,
             b.joints.size(), a.joints.size(), advice);
    if (a.fixed_axes != b.fixed_axes)
        fail(Status::unsupported, "{} has a different format than the first clip{}", name, advice);
    const double longest = longest_offset(a);
    const std::size_t body_root = clip::body_root(first);
    std::string differs;
    double most = tolerance * rounding;
    for (std::size_t j = 0; j < a.joints.size(); ++j) {
        check_joint(a.joints[j], b.joints[j], j, name);
        if (is_placed(a.joints[j], j, body_root))
            continue;
        const double difference = offset_difference(a.joints[j], b.joints[j], longest);
        if (difference > 1)
            fail(
                Status::unsupported,
                "the offset of joint \"{}\" of {} differs from the first clip's by more than 1 %{}",
                b.joints[j].name, name, advice);
        if (difference > most) {
            most = difference;
            differs = b.joints[j].name;
        }
    }
    return differs;
}

} // namespace stltsa::synthesis
