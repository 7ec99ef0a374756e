// SPDX-License-Identifier: BSD-3-Clause
// Shared by the tests of src/motion.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "assertions.hpp"
#include "linalg/matrix.hpp"

namespace motion_testing {

using stltsa::ConstMatrixView;
using stltsa::Matrix;

inline constexpr double turn = 2 * std::numbers::pi;

/// samples x features, feature c at time t seconds given by `value`.
inline Matrix sampled(std::int64_t samples, std::int64_t features, double fps,
                      const std::function<double(double t, std::int64_t c)>& value) {
    Matrix result(samples, features);
    for (std::int64_t i = 0; i < samples; ++i)
        for (std::int64_t c = 0; c < features; ++c)
            result(i, c) = value(static_cast<double>(i) / fps, c);
    return result;
}

/// Amplitude of each of ten features over a cycle, and its share at twice the frequency.
inline double cyclic_pose(double phase, std::int64_t c) {
    const auto angle = static_cast<double>(c);
    return std::sin(turn * phase + angle) + 0.4 * std::sin(2 * turn * phase + 2.3 * angle);
}

inline void add_noise(Matrix& samples, double deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (std::int64_t c = 0; c < samples.cols(); ++c)
            samples(i, c) += deviation * normal(random);
}

/// Stands, cycles with growing and finally shrinking amplitude, stands.
struct Exercise {
    double stands = 1; ///< seconds of standing before
    double period = 1.2;
    double cycles = 5;   ///< at full amplitude
    double fading = 0.6; ///< seconds of starting and of stopping
    double rests = 1.5;  ///< seconds of standing after

    double moves_until() const { return stands + 2 * fading + cycles * period; }
    double seconds() const { return moves_until() + rests; }

    double amplitude(double t) const {
        const double in = std::min((t - stands) / fading, (moves_until() - t) / fading);
        const double u = std::min(std::max(in, 0.0), 1.0);
        return u * u * (3 - 2 * u);
    }
    Matrix samples(double fps) const {
        return sampled(static_cast<std::int64_t>(seconds() * fps), 10, fps,
                       [&](double t, std::int64_t c) {
                           return amplitude(t) * cyclic_pose((t - stands) / period, c);
                       });
    }
};

} // namespace motion_testing
