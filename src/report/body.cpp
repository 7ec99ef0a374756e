// SPDX-License-Identifier: BSD-3-Clause
#include "report/body.hpp"

#include <algorithm>
#include <limits>

#include "base/checkpoint.hpp"
#include "base/side_name.hpp"
#include "clip/body/heading.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/features/column_owners.hpp"
#include "report/packed.hpp"

namespace stltsa::report {
namespace {

/// More numbers are not packed, for the sake of time.
constexpr std::int64_t most_values = 12'000'000;

std::vector<std::string> names_of(const clip::Clip& clip) {
    std::vector<std::string> names;
    if (clip.skeleton) {
        const auto& joints = clip.skeleton->joints;
        for (const clip::Joint& joint : joints)
            names.push_back(joint.end_site && joint.parent >= 0
                                ? joints[static_cast<std::size_t>(joint.parent)].name + " end"
                                : joint.name);
        return names;
    }
    if (clip.space == 0)
        return clip::column_owners(clip, clip::Features::raw);
    const auto owners = clip::column_owners(clip, clip::Features::points);
    for (std::size_t c = 0; c < owners.size(); c += static_cast<std::size_t>(clip.space))
        names.push_back(owners[c]);
    return names;
}

/// Positions in every step-th frame; NaN where they are missing, and of joints above the body.
Matrix places(const clip::Clip& clip, std::int64_t step) {
    Matrix rows((clip.frames() + step - 1) / step, places_width(clip));
    const std::size_t above = clip.skeleton ? 3 * clip::body_root(clip) : 0;
    clip::Pose pose;
    for (std::int64_t r = 0; r < rows.rows(); ++r) {
        double* const row = rows.row(r);
        const double* const values = clip.values.row(r * step);
        if (clip.skeleton) {
            pose.place(*clip.skeleton, values);
            for (std::size_t j = 0; j < pose.position.size(); ++j)
                std::ranges::copy(pose.position[j], row + 3 * j);
            std::fill_n(row, above, std::numeric_limits<double>::quiet_NaN());
            continue;
        }
        std::copy_n(values, rows.cols(), row);
        for (int c = 0; clip.space > 0 && c < rows.cols(); c += clip.space)
            if (clip::is_missing(values + c, clip.space))
                std::fill_n(row + c, clip.space, std::numeric_limits<double>::quiet_NaN());
    }
    return rows;
}

Json parts_json(const clip::Clip& clip, const std::vector<Part>& parts) {
    std::vector<Json> list;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int parent = clip.skeleton ? clip.skeleton->joints[i].parent : -1;
        list.push_back(JsonObject("name", parts[i].name, "parent", parent, "side", parts[i].side,
                                  "partner", parts[i].partner));
    }
    return list;
}

} // namespace

std::int64_t places_width(const clip::Clip& clip) {
    return clip.skeleton ? 3 * std::ssize(clip.skeleton->joints) : clip.values.cols();
}

std::vector<Part> parts_of(const clip::Clip& clip) {
    std::vector<Part> parts;
    const std::vector<std::string> names = names_of(clip);
    const std::vector<Sided> sides = sides_of(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t partner = sides[i].partner;
        parts.push_back({names[i], static_cast<int>(sides[i].side),
                         partner == i ? -1 : static_cast<std::int64_t>(partner)});
    }
    return parts;
}

Json body_json(const clip::Clip& clip, const std::vector<Part>& parts, clip::Axis up,
               std::int64_t longest_text) {
    const int space = clip.skeleton ? 3 : clip.space;
    const char* const kind = clip.skeleton ? "skeleton" : space > 0 ? "points" : "columns";
    const std::int64_t ranges = std::max<std::int64_t>(space > 0 ? space : places_width(clip), 1);
    const std::int64_t values = clip.frames() * places_width(clip);
    std::int64_t step = std::max<std::int64_t>(1, (values + most_values - 1) / most_values);
    const auto pack = [&] {
        checkpoint();
        const Matrix chosen = places(clip, step);
        checkpoint();
        return packed(chosen.view(), ranges);
    };
    Json kept = pack();
    while (std::ssize(kept.text()) > longest_text && step < clip.frames()) {
        step = step * std::ssize(kept.text()) / longest_text + 1;
        kept = pack();
    }
    return JsonObject("kind", kind, "space", space, "up", static_cast<int>(up) - 1, "parts",
                      parts_json(clip, parts), "step", step, "places", kept);
}

} // namespace stltsa::report
