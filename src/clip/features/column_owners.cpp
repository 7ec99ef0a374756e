// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/column_owners.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "clip/body/heading.hpp"
#include "clip/body/level_axes.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/points.hpp"

namespace stltsa::clip {
namespace {

/// Joints nearer to the middle than this share of the median distance belong to no side.
constexpr double middle = 0.25;
/// Joints higher than this share of the highest are of the trunk.
constexpr double trunk = 0.25;

std::string name_of(const Clip& clip, std::size_t joint) {
    const Joint& owner = clip.skeleton->joints[joint];
    if (owner.end_site && owner.parent >= 0)
        return clip.skeleton->joints[static_cast<std::size_t>(owner.parent)].name + " end";
    return owner.name;
}

std::vector<std::string> repeated(const Clip& clip, const std::vector<std::size_t>& joints,
                                  int columns) {
    std::vector<std::string> names;
    for (const std::size_t joint : joints)
        names.insert(names.end(), static_cast<std::size_t>(columns), name_of(clip, joint));
    return names;
}

std::vector<std::size_t> from(std::size_t root, std::size_t count) {
    std::vector<std::size_t> joints;
    for (std::size_t joint = root; joint < count; ++joint)
        joints.push_back(joint);
    return joints;
}

std::vector<std::string> rotation_owners(const Clip& clip, std::size_t root) {
    std::vector<std::string> names;
    for (std::size_t j = root + 1; j < clip.skeleton->joints.size(); ++j)
        for (const Channel channel : clip.skeleton->joints[j].channels)
            if (is_rotation(channel))
                names.push_back(name_of(clip, j));
    return names;
}

/// Mean positions of the joints in the features.
std::vector<Vec3> mean_positions(ConstMatrixView samples) {
    std::vector<Vec3> means(static_cast<std::size_t>(samples.cols / 3));
    for (std::int64_t i = 0; i < samples.rows; ++i)
        for (std::size_t j = 0; j < means.size(); ++j)
            for (std::size_t a = 0; a < 3; ++a)
                means[j][a] += samples(i, static_cast<std::int64_t>(3 * j + a)) /
                               static_cast<double>(samples.rows);
    return means;
}

/// Whether each joint of the body is above its root, or hangs from one that is: hands may hang
/// lower than the hips, and swing against the feet.
std::vector<bool> on_trunk(const Skeleton& skeleton, std::size_t root,
                           const std::vector<Vec3>& means, std::size_t above) {
    double highest = 0;
    for (const Vec3& mean : means)
        highest = std::max(highest, mean[above]);
    std::vector<bool> upper;
    for (std::size_t j = 0; j < means.size(); ++j) {
        const int parent = skeleton.joints[root + j].parent - static_cast<int>(root);
        upper.push_back((parent >= 0 && upper[static_cast<std::size_t>(parent)]) ||
                        means[j][above] > trunk * highest);
    }
    return upper;
}

} // namespace

std::vector<std::string> column_owners(const Clip& clip, Features kind) {
    if (kind == Features::raw || !clip.skeleton) {
        std::vector<std::string> names = clip.channel_names;
        const bool points = kind == Features::points;
        for (std::string& name : names)
            if (points && !name.empty())
                name = point_name(name);
        for (std::int64_t c = static_cast<std::int64_t>(names.size()); c < clip.values.cols(); ++c)
            names.push_back(points ? format_text("point {}", c / point_columns(clip) + 1)
                                   : format_text("column {}", c + 1));
        return names;
    }
    const std::size_t root = body_root(clip);
    if (kind == Features::euler)
        return rotation_owners(clip, root);
    if (kind == Features::rotations6d)
        return repeated(clip, turning_joints(*clip.skeleton, root), 6);
    return repeated(clip, from(root, clip.skeleton->joints.size()), 3);
}

std::vector<double> side_weights(const Clip& clip, Features kind, Axis up,
                                 ConstMatrixView samples) {
    if (!clip.skeleton || kind != Features::positions || up == Axis::none)
        return {};
    const auto above = static_cast<std::size_t>(up) - 1;
    const LevelAxes axes = level_axes(*clip.skeleton, body_root(clip), up);
    const std::vector<Vec3> means = mean_positions(samples);
    const std::vector<bool> of_trunk = on_trunk(*clip.skeleton, body_root(clip), means, above);
    std::vector<std::size_t> low;
    std::vector<double> distances;
    for (std::size_t j = 0; j < means.size(); ++j)
        if (!of_trunk[j] && means[j][above] < 0) {
            low.push_back(j);
            distances.push_back(std::abs(means[j][axes.lateral]));
        }
    if (low.empty())
        return {};
    std::nth_element(distances.begin(),
                     distances.begin() + static_cast<std::ptrdiff_t>(low.size() / 2),
                     distances.end());
    const double least = middle * distances[low.size() / 2];
    std::vector<double> weights(static_cast<std::size_t>(samples.cols));
    int sides[2] = {};
    for (const std::size_t j : low) {
        if (!(std::abs(means[j][axes.lateral]) > least))
            continue;
        const bool positive = means[j][axes.lateral] > 0;
        weights[3 * j + axes.forward] = positive ? 1 : -1;
        ++sides[positive ? 0 : 1];
    }
    return sides[0] > 0 && sides[1] > 0 ? weights : std::vector<double>();
}

} // namespace stltsa::clip
