// SPDX-License-Identifier: BSD-3-Clause
#include "clip/body/level_axes.hpp"

#include <cmath>

namespace stltsa::clip {
namespace {

/// Positions of the joints in the axes of the body root if no joint turns.
std::vector<Vec3> neutral_positions(const Skeleton& skeleton, std::size_t root) {
    std::vector<Vec3> places(skeleton.joints.size());
    for (std::size_t j = root + 1; j < places.size(); ++j)
        if (const int parent = skeleton.joints[j].parent; parent >= static_cast<int>(root))
            for (std::size_t a = 0; a < 3; ++a)
                places[j][a] =
                    places[static_cast<std::size_t>(parent)][a] + skeleton.joints[j].offset[a];
    return places;
}

} // namespace

LevelAxes level_axes(const Skeleton& skeleton, std::size_t root, Axis up) {
    const auto above = static_cast<std::size_t>(up) - 1;
    const std::size_t axes[] = {(above + 1) % 3, (above + 2) % 3};
    double both_sides[2] = {};
    const auto places = neutral_positions(skeleton, root);
    for (int a = 0; a < 2; ++a) {
        double sum = 0, sizes = 0;
        for (const Vec3& place : places) {
            sum += place[axes[a]];
            sizes += std::abs(place[axes[a]]);
        }
        both_sides[a] = sizes - std::abs(sum);
    }
    const bool first = both_sides[0] >= both_sides[1];
    return {axes[first ? 0 : 1], axes[first ? 1 : 0]};
}

} // namespace stltsa::clip
