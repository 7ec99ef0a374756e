// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cycle_likeness.hpp"

#include <algorithm>

#include "linalg/simd.hpp"

namespace stltsa::recording {
namespace {

constexpr std::int64_t likeness_phases = 24;

} // namespace

std::vector<double> cycle_likenesses(const Signal& signal, const std::vector<Interval>& cycles) {
    Matrix mean(likeness_phases, signal.cols());
    const std::int64_t size = likeness_phases * signal.cols();
    for (const Interval& cycle : cycles)
        axpy(1 / static_cast<double>(cycles.size()),
             rows_at(signal.poses.view(), cycle.begin, cycle.end, likeness_phases).data(),
             mean.data(), size);
    double swing = 0;
    std::vector<double> center(static_cast<std::size_t>(signal.cols()));
    for (std::int64_t p = 0; p < likeness_phases; ++p)
        axpy(1.0 / likeness_phases, mean.row(p), center.data(), signal.cols());
    for (std::int64_t p = 0; p < likeness_phases; ++p)
        swing += squared_distance(mean.row(p), center.data(), signal.cols());
    std::vector<double> result;
    for (const Interval& cycle : cycles) {
        const Matrix own = rows_at(signal.poses.view(), cycle.begin, cycle.end, likeness_phases);
        const double apart = squared_distance(own.data(), mean.data(), size);
        result.push_back(swing > 0 ? std::clamp(1 - apart / (2 * swing), 0.0, 1.0) : 0);
    }
    return result;
}

} // namespace stltsa::recording
