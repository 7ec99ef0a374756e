// SPDX-License-Identifier: BSD-3-Clause
#include "results/compared_columns.hpp"

#include <map>
#include <utility>

#include "base/side_name.hpp"
#include "clip/body/skeleton.hpp"

namespace stltsa::results {
namespace {

/// A joint, a point or a column of the file.
struct Part {
    std::string name;
    std::int64_t begin = 0, count = 0; ///< columns of the features
};

/// The columns of a part follow one another. Each column of plain numbers is a part of its own.
std::vector<Part> parts_of(const Phased& phased) {
    std::vector<Part> parts;
    const bool single = phased.samples.features == clip::Features::raw;
    const std::int64_t width = in_space(phased) ? 3 : 6;
    for (std::size_t c = 0; c < phased.owners.size(); ++c) {
        if (single || parts.empty() || parts.back().name != phased.owners[c] ||
            parts.back().count == width)
            parts.push_back({phased.owners[c], static_cast<std::int64_t>(c), 0});
        ++parts.back().count;
    }
    return parts;
}

/// Names of the columns of the parts.
std::vector<std::string> axes_of(const Phased& phased) {
    std::vector<std::string> axes;
    if (phased.samples.features == clip::Features::euler)
        for (std::size_t j = phased.of->body.root + 1; j < phased.of->body.skeleton.joints.size();
             ++j)
            for (const clip::Channel channel : phased.of->body.skeleton.joints[j].channels)
                if (clip::is_rotation(channel))
                    axes.emplace_back(clip::channel_name(channel));
    if (axes.empty())
        for (const Part& part : parts_of(phased))
            for (std::int64_t i = 0; i < part.count; ++i)
                axes.push_back(part.count == 1 ? ""
                               : part.count <= 3
                                   ? std::string(1, "xyz"[i])
                                   : format_text("{}", i + 1)); // of a rotation matrix
    return axes;
}

using Key = std::pair<std::string, std::size_t>;

/// Parts by name; parts with the same name by their order.
std::map<Key, Part> by_name(const std::vector<Part>& parts) {
    std::map<Key, Part> result;
    for (const Part& part : parts) {
        std::size_t order = 0;
        while (result.contains({part.name, order}))
            ++order;
        result[{part.name, order}] = part;
    }
    return result;
}

void append(const Part& one, const Part& other, std::int64_t turn,
            const std::vector<std::string>& axes, CommonColumns& common) {
    const auto part = static_cast<std::int64_t>(common.names.size());
    for (std::int64_t i = 0; i < one.count; ++i) {
        common.first.push_back(one.begin + i);
        common.second.push_back(other.begin + (i + turn) % one.count);
        common.part.push_back(part);
        common.axis.push_back(axes[static_cast<std::size_t>(one.begin + i)]);
    }
    common.names.push_back(one.name);
    common.other_names.push_back(other.name);
}

std::string some(const std::vector<Part>& parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size() && i < 3; ++i)
        text += (i > 0 ? ", " : "") + parts[i].name;
    return parts.size() > 3 ? text + ", ..." : text;
}

/// For each column of the left side the one of the right side whose name differs only in the side.
/// Columns with the same name, such as the coordinates of a joint, are distinguished by their
/// order. Throws Status::unsupported if there are none.
std::map<std::int64_t, std::int64_t> right_columns(std::span<const std::string> names) {
    const std::vector<Sided> sides = sides_of(names);
    std::map<std::int64_t, std::int64_t> right_of;
    for (std::size_t c = 0; c < names.size(); ++c)
        if (sides[c].side == Side::left && sides[c].partner != c)
            right_of.emplace(static_cast<std::int64_t>(c),
                             static_cast<std::int64_t>(sides[c].partner));
    if (right_of.empty())
        fail(Status::unsupported, "no two names differ only in the side, as LeftFoot and "
                                  "RightFoot, L_toe and R_toe do");
    return right_of;
}

/// By how many places the axes of the second are rotated, so that both have the same up axis.
std::int64_t axis_turn(const Phased& first, const Phased& second) {
    const auto up = [](const Phased& of) { return static_cast<std::int64_t>(of.samples.up); };
    return in_space(first) && up(first) > 0 && up(second) > 0 ? (up(second) - up(first) + 3) % 3
                                                              : 0;
}

} // namespace

bool in_space(const Phased& phased) {
    return phased.samples.features == clip::Features::positions ||
           (phased.samples.features == clip::Features::points &&
            phased.of->body.shape.rule.width == 3);
}

CommonColumns common_columns(const Phased& first, const Phased& second) {
    if (first.samples.features != second.samples.features || in_space(first) != in_space(second))
        fail(Status::shape,
             "the clips have different features: decompose both with the same option "
             "features");
    const auto parts = parts_of(first), others = parts_of(second);
    const auto of_first = by_name(parts), of_second = by_name(others);
    const auto axes = axes_of(first);
    const std::int64_t turn = axis_turn(first, second);
    CommonColumns common;
    std::map<std::string, std::size_t> seen;
    for (const Part& part : parts) {
        const auto other = of_second.find({part.name, seen[part.name]++});
        if (other != of_second.end() && other->second.count == part.count)
            append(part, other->second, turn, axes, common);
        else
            common.left_out.push_back(part.name);
    }
    for (const auto& [key, part] : of_second)
        if (const auto one = of_first.find(key);
            one == of_first.end() || one->second.count != part.count)
            common.other_left_out.push_back(part.name);
    if (common.names.empty())
        fail(Status::shape,
             "the clips have no joint, point or column of the same name: the first has {}, the "
             "second {}",
             some(parts), some(others));
    return common;
}

CommonColumns side_columns_of(const Phased& phased) {
    const auto axes = axes_of(phased);
    const auto right_of = right_columns(phased.owners);
    CommonColumns common;
    for (const Part& part : parts_of(phased)) {
        const auto right = right_of.find(part.begin);
        if (right == right_of.end())
            continue;
        append(part, part, 0, axes, common);
        common.other_names.back() = phased.owners[static_cast<std::size_t>(right->second)];
    }
    return common;
}

CommonColumns side_columns_of(std::span<const std::string> names) {
    const std::vector<std::string> axes(names.size());
    CommonColumns common;
    for (const auto& [left, right] : right_columns(names))
        append({names[static_cast<std::size_t>(left)], left, 1},
               {names[static_cast<std::size_t>(right)], right, 1}, 0, axes, common);
    return common;
}

} // namespace stltsa::results
