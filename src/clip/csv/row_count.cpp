// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/row_count.hpp"

#include <algorithm>
#include <cmath>

namespace stltsa::clip {
namespace {

/// Beyond, whole numbers have no exact differences.
constexpr double largest = 9007199254740992;

/// Continues a counter of 8, 16 or 32 bits where it begins again.
void unwrap(std::vector<double>& values) {
    const double range = *std::ranges::max_element(values) + 1;
    if (range != 256 && range != 65536 && range != 4294967296)
        return;
    double before = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        values[i] += before;
        if (values[i] < values[i - 1]) {
            before += range;
            values[i] += range;
        }
    }
}

} // namespace

bool are_whole(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) {
        return std::abs(value) < largest && value == std::floor(value);
    });
}

std::optional<RowCount> row_count(std::vector<double> values) {
    if (!are_whole(values))
        return std::nullopt;
    unwrap(values);
    std::vector<double> steps;
    for (std::size_t i = 1; i < values.size(); ++i)
        steps.push_back(values[i] - values[i - 1]);
    RowCount count;
    count.places.push_back(0);
    if (steps.empty())
        return count;
    const auto middle = steps.begin() + (std::ssize(steps) - 1) / 2;
    std::ranges::nth_element(steps, middle);
    const double step = *middle; // no other may be less, so at least half of them are this one
    if (!(step > 0 && step < largest))
        return std::nullopt;
    count.step = static_cast<std::int64_t>(step);
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double places = (values[i] - values[i - 1]) / step;
        if (!(places > 0) || places != std::floor(places))
            return std::nullopt;
        count.places.push_back(count.places.back() + static_cast<std::int64_t>(places));
    }
    return count;
}

bool add_subframes(std::vector<double>& frames, const std::vector<double>& subframes) {
    if (!are_whole(subframes))
        return false;
    const auto [least, most] = std::ranges::minmax(subframes);
    const double per_frame = most - least + 1;
    for (std::size_t i = 0; i < frames.size(); ++i)
        frames[i] = frames[i] * per_frame + subframes[i] - least;
    return true;
}

} // namespace stltsa::clip
