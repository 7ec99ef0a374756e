// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/behaviors.hpp"

#include "motion/behaviors/grouping.hpp"
#include "motion/behaviors/likeness.hpp"

namespace stltsa::motion {
namespace {

/// Leaves out borders between neighbors that are one behavior.
std::vector<std::int64_t> without_alike(const KernelFeatures& features,
                                        const std::vector<std::int64_t>& borders,
                                        const std::function<void()>& poll) {
    const Describer describe(features);
    std::vector<Description> done;
    std::int64_t begin = 0;
    for (const std::int64_t border : borders) {
        done.push_back(describe({begin, border}));
        begin = border;
    }
    done.push_back(describe({begin, features.count()}));
    const std::vector<int> labels = group(
        static_cast<std::int64_t>(done.size()), 1 - same_behavior,
        [&](std::int64_t i, std::int64_t k) {
            return 1 -
                   likeness(done[static_cast<std::size_t>(i)], done[static_cast<std::size_t>(k)]);
        },
        poll);
    std::vector<std::int64_t> kept;
    for (std::size_t i = 0; i < borders.size(); ++i)
        if (labels[i] != labels[i + 1])
            kept.push_back(borders[i]);
    return kept;
}

} // namespace

std::vector<std::int64_t> behavior_borders(const KernelFeatures& features, double price,
                                           const std::function<void()>& poll) {
    std::vector<std::int64_t> borders = change_points(features, price, poll);
    if (price >= border_price(features))
        borders = without_alike(features, borders, poll);
    for (std::int64_t& border : borders)
        border *= features.step();
    return borders;
}

} // namespace stltsa::motion
