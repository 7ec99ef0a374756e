// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/near_groups.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

namespace stltsa::clip {
namespace {

/// The mean is of at most so many rows, evenly chosen.
constexpr std::int64_t most_measured = 1000;

struct Place {
    std::array<double, 3> at = {};
    std::int64_t group = 0;
};

Place place_of(const Matrix& rows, int width, std::int64_t group) {
    Place place{{}, group};
    if (width == 1) {
        place.at[0] = static_cast<double>(group);
        return place;
    }
    const std::int64_t step = 1 + (rows.rows() - 1) / most_measured;
    const std::int64_t taken = (rows.rows() - 1) / step + 1;
    const auto count = static_cast<double>(taken);
    for (std::int64_t i = 0; i < rows.rows(); i += step)
        for (int c = 0; c < width; ++c)
            place.at[static_cast<std::size_t>(c)] += rows(i, width * group + c) / count;
    return place;
}

/// Halves the places along the axis on which they spread most, until each part is small enough.
void divide(std::span<Place> places, std::int64_t most,
            std::vector<std::vector<std::int64_t>>& sets) {
    if (std::ssize(places) <= most) {
        std::vector<std::int64_t>& set = sets.emplace_back();
        std::ranges::transform(places, std::back_inserter(set), &Place::group);
        std::ranges::sort(set);
        return;
    }
    std::size_t widest = 0;
    double largest = -1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto along = [axis](const Place& place) { return place.at[axis]; };
        const auto [low, high] = std::ranges::minmax(places, {}, along);
        if (const double spread = high.at[axis] - low.at[axis]; spread > largest) {
            widest = axis;
            largest = spread;
        }
    }
    const auto middle = places.begin() + std::ssize(places) / 2;
    std::ranges::nth_element(places, middle, [widest](const Place& a, const Place& b) {
        return a.at[widest] != b.at[widest] ? a.at[widest] < b.at[widest] : a.group < b.group;
    });
    divide({places.begin(), middle}, most, sets);
    divide({middle, places.end()}, most, sets);
}

} // namespace

std::vector<std::vector<std::int64_t>> near_groups(const Matrix& rows, int width,
                                                   const std::vector<std::int64_t>& groups,
                                                   std::int64_t most) {
    std::vector<Place> places;
    places.reserve(groups.size());
    for (const std::int64_t group : groups)
        places.push_back(place_of(rows, width, group));
    std::vector<std::vector<std::int64_t>> sets;
    divide(places, most, sets);
    return sets;
}

} // namespace stltsa::clip
