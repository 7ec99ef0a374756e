// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/mapping/support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "linalg/simd.hpp"

namespace stltsa::ltsa {
namespace {

/// Rows closer in time than this share of a period belong to the same repetition.
constexpr double same_repetition = 0.3;

/// Number of searches: enough for a quantile, and short compared with a fit.
std::int64_t search_count(std::int64_t rows) {
    constexpr std::int64_t most = 300;
    constexpr std::int64_t least = 30;
    constexpr std::int64_t distances = 3'000'000;
    return std::clamp(distances / std::max<std::int64_t>(rows, 1), least, most);
}

/// The quantile of the values at `share`; 0 if there are none.
double quantile(std::vector<double>& values, double share) {
    if (values.empty())
        return 0;
    const auto rank = std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

double distance(ConstMatrixView x, std::int64_t a, std::int64_t b) {
    return std::sqrt(squared_distance(x.row(a), x.row(b), x.cols));
}

/// Distances from each row to the next of the same component.
std::vector<double> steps(ConstMatrixView x, const NearestRows& tree, const Timeline& timeline) {
    std::vector<double> result;
    const auto& rows = tree.rows();
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
        if (timeline.next(rows[i]) == rows[i + 1])
            result.push_back(distance(x, rows[i], rows[i + 1]));
    return result;
}

/// Distances from evenly spaced rows to the nearest row outside their zone, if there is one.
template <class ZoneOf>
std::vector<double> distances_outside(ConstMatrixView x, const NearestRows& tree,
                                      const ZoneOf& zone_of) {
    std::vector<double> result;
    const auto count = static_cast<std::int64_t>(tree.rows().size());
    const std::int64_t stride = 1 + (count - 1) / search_count(count);
    for (std::int64_t i = 0; i < count; i += stride) {
        const std::int64_t row = tree.rows()[static_cast<std::size_t>(i)];
        const auto found = tree.nearest_outside(x.row(row), 1, zone_of(row));
        if (!found.empty())
            result.push_back(std::sqrt(found.front().distance));
    }
    return result;
}

void append(std::vector<double>& all, const std::vector<double>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

double support_limit(ConstMatrixView x, std::span<const NearestRows> trees,
                     const Timeline& timeline, Mode mode, double period) {
    std::vector<double> following, spacing, repetition;
    const auto vicinity = static_cast<std::int64_t>(same_repetition * period);
    for (const NearestRows& tree : trees) {
        append(following, steps(x, tree, timeline));
        if (mode == Mode::spatial)
            append(spacing, distances_outside(x, tree, [](std::int64_t row) {
                       return RowRange{row, row + 1};
                   }));
        if (vicinity > 0)
            append(repetition, distances_outside(x, tree, [&](std::int64_t row) {
                       return timeline.around(row, vicinity);
                   }));
    }
    // If nearly every row equals another, the spacing is 0: then the steps decide here, too.
    double limit = mode == Mode::spatial ? quantile(spacing, 0.99) : 0;
    if (!(limit > 0))
        limit = quantile(following, 0.99);
    return std::max(limit, quantile(repetition, 0.5));
}

} // namespace stltsa::ltsa
