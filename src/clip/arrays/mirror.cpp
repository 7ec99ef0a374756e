// SPDX-License-Identifier: BSD-3-Clause
#include "clip/arrays/mirror.hpp"

#include <algorithm>

#include "base/side_name.hpp"
#include "clip/body/angles.hpp"
#include "clip/body/heading.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/body/level_axes.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/points.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

using Partners = std::vector<std::size_t>;

/// Of each name the index of that on the other side; its own without one.
Partners partners_by_name(const std::vector<std::string>& names) {
    Partners partners;
    for (const Sided& sided : sides_of(names))
        partners.push_back(sided.partner);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (partners[partners[i]] != i)
            fail(Status::unsupported,
                 "{} and {} cannot both be the other side of {}: name the sides left and right",
                 in_quotes(names[i]), in_quotes(names[partners[partners[i]]]),
                 in_quotes(names[partners[i]]));
    return partners;
}

void check_sides(const Partners& partners, const char* what) {
    for (std::size_t i = 0; i < partners.size(); ++i)
        if (partners[i] != i)
            return;
    fail(Status::unsupported,
         "no two names of {} differ only in the side, as LeftFoot and RightFoot, L_toe and R_toe "
         "do: which of them belong together is unknown",
         what);
}

/// End sites often have no names of their own: the partner is the end site at the same place among
/// the children of the parent's partner.
std::size_t end_site_partner(const Skeleton& skeleton, const Partners& partners,
                             std::size_t joint) {
    const int parent = skeleton.joints[joint].parent;
    const auto end_sites_of = [&](int owner) {
        std::vector<std::size_t> found;
        for (std::size_t j = 0; j < skeleton.joints.size(); ++j)
            if (skeleton.joints[j].end_site && skeleton.joints[j].parent == owner)
                found.push_back(j);
        return found;
    };
    const auto here = end_sites_of(parent);
    const auto there = end_sites_of(static_cast<int>(partners[static_cast<std::size_t>(parent)]));
    const auto place = static_cast<std::size_t>(std::ranges::find(here, joint) - here.begin());
    if (there.size() != here.size())
        fail(Status::unsupported, "joint {} has {} end sites, but its other side {}",
             in_quotes(skeleton.joints[static_cast<std::size_t>(parent)].name), here.size(),
             there.size());
    return there[place];
}

Partners partners_of(const Skeleton& skeleton) {
    std::vector<std::string> names;
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j)
        names.push_back(skeleton.joints[j].end_site ? "" : skeleton.joints[j].name);
    Partners partners = partners_by_name(names);
    check_sides(partners, "joints");
    for (std::size_t j = 0; j < partners.size(); ++j) {
        const Joint& joint = skeleton.joints[j];
        if (joint.end_site)
            partners[j] = end_site_partner(skeleton, partners, j);
        const Joint& partner = skeleton.joints[partners[j]];
        const auto parent = static_cast<std::size_t>(std::max(joint.parent, 0));
        if (joint.parent >= 0 && static_cast<int>(partners[parent]) != partner.parent)
            fail(Status::unsupported,
                 "joints {} and {} are the two sides of one another, but hang from joints that are "
                 "not",
                 in_quotes(joint.name), in_quotes(partner.name));
    }
    return partners;
}

Vec3 reflected(Vec3 place, std::size_t axis) {
    place[axis] = -place[axis];
    return place;
}

/// S R S for the reflection S: the axis of a rotation is an axial vector.
Quaternion reflected(const Quaternion& q, std::size_t axis) {
    return {q.w, axis == 0 ? q.x : -q.x, axis == 1 ? q.y : -q.y, axis == 2 ? q.z : -q.z};
}

std::string channels_of(const Joint& joint) {
    std::string text;
    for (const Channel channel : joint.channels)
        text += format_text("{}{}", text.empty() ? "" : " ", channel_name(channel));
    return text.empty() ? "none" : text;
}

/// Throws if the values of the joint do not give this place and rotation of its other side.
void check_moves_alike(const Skeleton& skeleton, const Joint& joint, const Joint& partner,
                       const double* values, const Vec3& place, const Quaternion& turned) {
    constexpr double rounding = 1e-3; // of an angle in radians, and of the place
    const Quaternion turn = conjugate(joint_rotation(joint, skeleton.fixed_axes, values)) * turned;
    if (2 * norm({turn.x, turn.y, turn.z}) > rounding ||
        norm(joint_translation(joint, values) - place) > rounding * norm(place))
        fail(
            Status::unsupported,
            "joint {} cannot move as its other side {} does, because their channels or axes differ "
            "({}; {}): a mirror image needs the same channels on both sides",
            in_quotes(joint.name), in_quotes(partner.name), channels_of(joint),
            channels_of(partner));
}

Clip mirrored_body(const Clip& clip, std::size_t axis) {
    const Skeleton& from = *clip.skeleton;
    const Partners partners = partners_of(from);
    Clip made = clip;
    made.skeleton->asf.clear(); // the bones of both sides change places
    if (made.format == Format::amc)
        made.format = Format::skeleton;
    for (std::size_t j = 0; j < partners.size(); ++j)
        made.skeleton->joints[j].offset = reflected(from.joints[partners[j]].offset, axis);
    const auto begins = channel_begins(from);
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        double* row = made.values.row(i);
        if (i > 0) // angles are chosen near those before
            std::copy_n(made.values.row(i - 1), made.values.cols(), row);
        for (std::size_t j = 0; j < partners.size(); ++j) {
            const Joint& partner = from.joints[partners[j]];
            const Joint& joint = made.skeleton->joints[j];
            const double* values = clip.values.row(i) + begins[partners[j]];
            const Vec3 place = reflected(joint_translation(partner, values), axis);
            const Quaternion turned =
                reflected(joint_rotation(partner, from.fixed_axes, values), axis);
            put_position(joint, place, row + begins[j]);
            put_rotation(joint, from.fixed_axes, turned, row + begins[j]);
            check_moves_alike(from, joint, partner, row + begins[j], place, turned);
        }
    }
    return made;
}

Clip mirrored_points(const Clip& clip, std::size_t axis, std::int64_t columns) {
    std::vector<std::string> names;
    for (std::size_t c = 0; c < clip.channel_names.size(); c += static_cast<std::size_t>(columns))
        names.emplace_back(point_name(clip.channel_names[c]));
    const Partners partners = partners_by_name(names);
    check_sides(partners, "points");
    Clip made = clip;
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::size_t p = 0; p < partners.size(); ++p)
            for (std::int64_t c = 0; c < columns; ++c) {
                const double value =
                    clip.values(i, columns * static_cast<std::int64_t>(partners[p]) + c);
                made.values(i, columns * static_cast<std::int64_t>(p) + c) =
                    c == static_cast<std::int64_t>(axis) ? -value : value;
            }
    return made;
}

/// The name on the other side; the same if it states no side.
std::string other_side(const std::string& name) {
    const Side side = side_of_name(name);
    for (const OtherSide& other : other_sides(name, false))
        if (side != Side::neither && other.side == side)
            return other.name;
    return name;
}

} // namespace

Clip mirrored(const Clip& clip, std::optional<Axis> up) {
    const bool points = !clip.skeleton && feature_kind(clip, {}) == Features::points;
    if (!clip.skeleton && !points)
        fail(Status::unsupported,
             "columns of bare numbers have no sides: a clip needs a skeleton, or "
             "points with names, to have a mirror image");
    const int columns = points ? point_columns(clip) : 3;
    const Axis upright = up ? *up : points ? points_up(clip) : up_axis(clip, up);
    // The heading of a skeleton is that of the root's axes, so that its image must not face
    // backward in them; the heading of points follows from their shape.
    Clip made =
        points ? mirrored_points(clip, columns == 2 ? 0 : static_cast<std::size_t>(upright) % 3,
                                 columns)
               : mirrored_body(clip, level_axes(*clip.skeleton, body_root(clip), upright).lateral);
    for (Event& event : made.events) {
        event.label = other_side(event.label);
        event.context = other_side(event.context);
    }
    made.notes.emplace_back("mirror image: left and right are exchanged");
    return made;
}

} // namespace stltsa::clip
