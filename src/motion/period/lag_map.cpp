// SPDX-License-Identifier: BSD-3-Clause
#include "motion/period/lag_map.hpp"

#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "linalg/simd.hpp"

namespace stltsa::motion {
namespace {

constexpr double lag_step = 0.03;
constexpr double times_per_second = 8;
/// Sigma of the window as a share of the lag, and at least in seconds; it ends at two sigma.
constexpr double window_share = 0.5;
constexpr double least_window_s = 0.1;
constexpr double window_end = 2;
/// Speeds below this share of the usual one do not count as motion.
constexpr double still = 0.15;

std::vector<double> lag_grid(double shortest, double longest) {
    std::vector<double> lags;
    for (double lag = std::log(shortest); lag <= std::log(longest) + 1e-9; lag += lag_step) {
        const double rounded = std::max(2.0, std::round(std::exp(lag)));
        if (lags.empty() || rounded > lags.back())
            lags.push_back(rounded);
    }
    return lags;
}

/// Velocities in units of the usual speed around them; 0 if nothing moves.
Matrix relative_velocities(const Signal& signal, Rows range) {
    Matrix relative(range.count(), signal.cols());
    for (std::int64_t i = 0; i < range.count(); ++i)
        if (const double usual = signal.usual[static_cast<std::size_t>(range.begin + i)]; usual > 0)
            axpy(1 / usual, signal.velocity.row(range.begin + i), relative.row(i), signal.cols());
    return relative;
}

struct Products {
    std::vector<double> both;   ///< of the velocities a lag apart
    std::vector<double> energy; ///< mean of their squares
};

void multiply(const Matrix& velocity, const std::vector<double>& squares, std::int64_t lag,
              Products& products) {
    const auto count = static_cast<std::size_t>(velocity.rows() - lag);
    products.both.resize(count);
    products.energy.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto row = static_cast<std::int64_t>(i);
        products.both[i] = dot(velocity.row(row), velocity.row(row + lag), velocity.cols());
        products.energy[i] =
            (squares[i] + squares[i + static_cast<std::size_t>(lag)]) / 2 + still * still;
    }
}

/// Ratio of the weighted sums around `middle`; what lies beyond the ends does not count.
double weighted_ratio(const Products& products, double middle, const std::vector<double>& weights) {
    const auto reach = static_cast<std::int64_t>(weights.size()) / 2;
    const auto center = static_cast<std::int64_t>(
        std::lround(std::clamp(middle, 0.0, static_cast<double>(products.both.size() - 1))));
    const std::int64_t first = std::max<std::int64_t>(0, center - reach);
    const std::int64_t last =
        std::min(static_cast<std::int64_t>(products.both.size()) - 1, center + reach);
    const double* weight = weights.data() + (first - center + reach);
    return dot(weight, products.both.data() + first, last - first + 1) /
           dot(weight, products.energy.data() + first, last - first + 1);
}

/// From one end to the other.
std::vector<double> window(double sigma) {
    const auto reach = static_cast<int>(window_end * sigma);
    std::vector<double> weights;
    for (int i = -reach; i <= reach; ++i)
        weights.push_back(std::exp(-0.5 * (i / sigma) * (i / sigma)));
    return weights;
}

} // namespace

LagMap make_lag_map(const Signal& signal, Rows range, double shortest, double longest) {
    LagMap map;
    map.lags = lag_grid(shortest, longest);
    map.hop = std::max<std::int64_t>(1, std::lround(signal.rate / times_per_second));
    map.times = (range.count() + map.hop - 1) / map.hop;
    map.match.assign(static_cast<std::size_t>(map.times) * map.lags.size(), -1);
    const Matrix velocity = relative_velocities(signal, range);
    std::vector<double> squares;
    for (std::int64_t i = 0; i < velocity.rows(); ++i)
        squares.push_back(dot(velocity.row(i), velocity.row(i), velocity.cols()));
    Products products;
    for (std::size_t l = 0; l < map.lags.size(); ++l) {
        const double lag = map.lags[l];
        if (lag >= static_cast<double>(range.count() - 2))
            continue;
        multiply(velocity, squares, static_cast<std::int64_t>(lag), products);
        const auto weights = window(std::max(window_share * lag, least_window_s * signal.rate));
        checkpoint(velocity.rows() * velocity.cols());
        for (std::int64_t t = 0; t < map.times; ++t) {
            map.match[static_cast<std::size_t>(t) * map.lags.size() + l] = static_cast<float>(
                weighted_ratio(products, static_cast<double>(t * map.hop) - lag / 2, weights));
            checkpoint(static_cast<std::int64_t>(weights.size()));
        }
    }
    return map;
}

} // namespace stltsa::motion
