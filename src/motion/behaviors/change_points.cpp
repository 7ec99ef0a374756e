// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/change_points.hpp"

#include <algorithm>
#include <limits>

#include "base/checkpoint.hpp"

namespace stltsa::motion {
namespace {

constexpr double price_of_bodies = 8;
constexpr double price_of_shapes = 14;
/// Limits segments to this many moments, so that the search is linear; drop_unpaid() removes the
/// borders that this forces.
constexpr std::int64_t longest_search = 1200;
/// Borders that save less than this share of their price are dropped.
constexpr double pays = 0.97;

std::vector<std::int64_t> search(const KernelFeatures& features, double price) {
    const std::int64_t n = features.count();
    std::vector<double> best(static_cast<std::size_t>(n + 1),
                             std::numeric_limits<double>::infinity());
    std::vector<std::int64_t> previous(best.size());
    best[0] = -price;
    std::vector<std::int64_t> candidates{0}, kept;
    std::vector<double> costs;
    for (std::int64_t t = 1; t <= n; ++t) {
        auto& total = best[static_cast<std::size_t>(t)];
        costs.clear();
        checkpoint(static_cast<std::int64_t>(candidates.size()) * features.size());
        for (const std::int64_t begin : candidates) {
            costs.push_back(best[static_cast<std::size_t>(begin)] + features.cost(begin, t));
            if (costs.back() + price < total) {
                total = costs.back() + price;
                previous[static_cast<std::size_t>(t)] = begin;
            }
        }
        kept.clear();
        for (std::size_t c = 0; c < candidates.size(); ++c)
            if (costs[c] <= total && t - candidates[c] < longest_search)
                kept.push_back(candidates[c]);
        kept.push_back(t);
        candidates.swap(kept);
    }
    std::vector<std::int64_t> borders;
    for (std::int64_t t = previous[static_cast<std::size_t>(n)]; t > 0;
         t = previous[static_cast<std::size_t>(t)])
        borders.push_back(t);
    std::reverse(borders.begin(), borders.end());
    return borders;
}

/// Drops the borders that pay least, one after another, until all pay.
void drop_unpaid(const KernelFeatures& features, double price, std::vector<std::int64_t>& borders) {
    const auto gain = [&](std::size_t i) {
        return features.gain(i == 0 ? 0 : borders[i - 1], borders[i],
                             i + 1 == borders.size() ? features.count() : borders[i + 1]);
    };
    std::vector<double> gains;
    for (std::size_t i = 0; i < borders.size(); ++i)
        gains.push_back(gain(i));
    while (!borders.empty()) {
        const auto least =
            static_cast<std::size_t>(std::min_element(gains.begin(), gains.end()) - gains.begin());
        if (gains[least] >= pays * price)
            return;
        borders.erase(borders.begin() + static_cast<std::ptrdiff_t>(least));
        gains.erase(gains.begin() + static_cast<std::ptrdiff_t>(least));
        if (least > 0)
            gains[least - 1] = gain(least - 1);
        if (least < borders.size())
            gains[least] = gain(least);
    }
}

} // namespace

double border_price(const KernelFeatures& features) {
    return features.of_shapes() ? price_of_shapes : price_of_bodies;
}

std::vector<std::int64_t> change_points(const KernelFeatures& features, double price) {
    std::vector<std::int64_t> borders = search(features, price);
    drop_unpaid(features, price, borders);
    return borders;
}

} // namespace stltsa::motion
