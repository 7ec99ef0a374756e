// SPDX-License-Identifier: BSD-3-Clause
#include "motion/curve/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stltsa::motion {

double quantile(std::span<const double> values, double share) {
    if (values.empty())
        return 0;
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

double robust_deviation(std::span<const double> values) {
    std::vector<double> sizes(values.size());
    std::transform(values.begin(), values.end(), sizes.begin(),
                   [](double value) { return std::abs(value); });
    return 1.4826 * median(sizes);
}

} // namespace stltsa::motion
