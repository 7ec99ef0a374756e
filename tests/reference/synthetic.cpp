// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic.hpp"

#include <cmath>

namespace reference {

Frames smooth_curve(std::size_t frames, std::size_t channels, double fastest, std::uint64_t seed) {
    constexpr int terms = 4;
    const double turn = 2 * std::acos(-1.0);
    Random random(seed);
    Frames x(frames, channels);
    for (std::size_t c = 0; c < channels; ++c)
        for (int term = 0; term < terms; ++term) {
            const double frequency = fastest * random.uniform();
            const double phase = turn * random.uniform();
            const double amplitude = random.uniform();
            for (std::size_t i = 0; i < frames; ++i)
                x(i, c) += amplitude * std::sin(turn * frequency * static_cast<double>(i) + phase);
        }
    return x;
}

Frames swiss_roll(std::size_t points, std::uint64_t seed) {
    const double pi = std::acos(-1.0);
    Random random(seed);
    Frames x(points, 3);
    for (std::size_t i = 0; i < points; ++i) {
        const double t = 1.5 * pi * (1 + 2 * random.uniform());
        x(i, 0) = t * std::cos(t);
        x(i, 1) = 21 * random.uniform();
        x(i, 2) = t * std::sin(t);
    }
    return x;
}

} // namespace reference
