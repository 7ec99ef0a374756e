// SPDX-License-Identifier: BSD-3-Clause
#include "phase/live_filter.hpp"

#include <cmath>
#include <numbers>

namespace stltsa::phase {

void LiveFilter::start(const double* row) {
    std::copy_n(row, last_.size(), last_.begin());
    pose1_ = pose_ = last_;
    std::ranges::fill(velocity_, 0);
}

/// What differs from the response to an endless straight line decays: with h = seconds / time
/// constant, d1 to e^-h d1, d2 to e^-h (d2 + h d1), and so on.
void LiveFilter::step(double seconds, const double* row) {
    const double h = seconds / filter_s, decay = std::exp(-h);
    for (std::size_t c = 0; c < last_.size(); ++c) {
        const double slope = (row[c] - last_[c]) / seconds;
        const double delay = slope * filter_s;
        const double off1 = pose1_[c] - (last_[c] - delay);
        const double off2 = pose_[c] - (last_[c] - 2 * delay);
        const double off3 = h * (off1 - off2 - h / 2 * off1) / filter_s;
        pose1_[c] = row[c] - delay + decay * off1;
        pose_[c] = row[c] - 2 * delay + decay * (off2 + h * off1);
        velocity_[c] = slope + decay * (velocity_[c] - slope + off3);
        last_[c] = row[c];
    }
}

double velocity_scale(double period_s) {
    constexpr double velocity_weight = 2;
    return velocity_weight * period_s / (2 * std::numbers::pi);
}

} // namespace stltsa::phase
