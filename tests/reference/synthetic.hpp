// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "neighbors.hpp"

namespace reference {

/// splitmix64 (Steele, Lea, Flood, OOPSLA 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  private:
    std::uint64_t state_;
};

/// A smooth curve: every channel is a sum of four sinusoids of at most `fastest` cycles per frame.
Frames smooth_curve(std::size_t frames, std::size_t channels, double fastest, std::uint64_t seed);

/// Points on a rolled sheet in three dimensions, in random order.
Frames swiss_roll(std::size_t points, std::uint64_t seed);

} // namespace reference
