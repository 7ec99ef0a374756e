// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace stltsa {

/// splitmix64 (Steele, Lea, Flood 2014): the same numbers on every machine, without global state.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// Uniform in [-1, 1).
    double symmetric() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        z ^= z >> 31;
        return static_cast<double>(z >> 11) * 0x1.0p-52 - 1.0;
    }

  private:
    std::uint64_t state_;
};

} // namespace stltsa
