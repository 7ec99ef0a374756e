// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/behaviors.hpp"

#include <algorithm>

#include "base/checkpoint.hpp"
#include "motion/behaviors/grouping.hpp"
#include "motion/behaviors/likeness.hpp"

namespace stltsa::motion {
namespace {

/// Borders that are asked for gain at least this.
constexpr double least_gain = 0.1;

/// Leaves out borders between neighbors that are one behavior.
std::vector<std::int64_t> without_alike(const KernelFeatures& features,
                                        const std::vector<std::int64_t>& borders) {
    const Describer describe(features);
    std::vector<Description> done;
    std::int64_t begin = 0;
    for (const std::int64_t border : borders) {
        done.push_back(describe({begin, border}));
        begin = border;
    }
    done.push_back(describe({begin, features.count()}));
    const std::vector<int> labels =
        group(static_cast<std::int64_t>(done.size()), 1 - same_behavior,
              [&](std::int64_t i, std::int64_t k) {
                  return 1 - likeness(done[static_cast<std::size_t>(i)],
                                      done[static_cast<std::size_t>(k)]);
              });
    std::vector<std::int64_t> kept;
    for (std::size_t i = 0; i < borders.size(); ++i)
        if (labels[i] != labels[i + 1])
            kept.push_back(borders[i]);
    return kept;
}

/// Where a range of moments is divided best, and what that gains.
struct Split {
    double gain = 0;
    std::int64_t at = 0;
};

Split best_split(const KernelFeatures& features, std::int64_t begin, std::int64_t end) {
    Split best;
    checkpoint((end - begin) * features.size());
    for (std::int64_t at = begin + 1; at < end; ++at)
        if (const double gain = features.gain(begin, at, end); gain > best.gain)
            best = {gain, at};
    return best;
}

/// Adds the border that gains most, and so on.
void add_borders(const KernelFeatures& features, std::int64_t count,
                 std::vector<std::int64_t>& borders) {
    borders.insert(borders.begin(), 0);
    borders.push_back(features.count());
    std::vector<Split> splits; // of the range that begins at each border
    for (std::size_t i = 0; i + 1 < borders.size(); ++i)
        splits.push_back(best_split(features, borders[i], borders[i + 1]));
    for (; count > 0; --count) {
        const auto best = std::ranges::max_element(splits, {}, &Split::gain);
        if (best->gain < least_gain)
            break;
        const auto i = static_cast<std::size_t>(best - splits.begin());
        borders.insert(borders.begin() + static_cast<std::ptrdiff_t>(i) + 1, best->at);
        splits.insert(best, best_split(features, borders[i], borders[i + 1]));
        splits[i + 1] = best_split(features, borders[i + 1], borders[i + 2]);
    }
    borders.pop_back();
    borders.erase(borders.begin());
}

} // namespace

std::vector<std::int64_t> behavior_borders(const KernelFeatures& features, std::int64_t more) {
    std::vector<std::int64_t> borders =
        without_alike(features, change_points(features, border_price(features)));
    if (more > 0)
        add_borders(features, more, borders);
    for (std::int64_t& border : borders)
        border *= features.step();
    return borders;
}

} // namespace stltsa::motion
