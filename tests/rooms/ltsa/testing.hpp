// SPDX-License-Identifier: BSD-3-Clause
// Shared by the tests of src/ltsa: frames of every kind, and the instruction sets to compare.
#pragma once

#include <vector>

#include "base/random.hpp"
#include "linalg/pack.hpp"
#include "motion/testing.hpp"

namespace ltsa_testing {

using namespace motion_testing;
using stltsa::Simd;

/// One cycle per second, at 120 frames per second.
inline Matrix cyclic(std::int64_t rows, std::int64_t cols) {
    return sampled(rows, cols, 120, cyclic_pose);
}

/// Uniform in [-1, 1).
inline Matrix noise(std::int64_t rows, std::int64_t cols, std::uint64_t seed = 3) {
    stltsa::Random random(seed);
    Matrix x(rows, cols);
    for (std::int64_t i = 0; i < rows * cols; ++i)
        x.data()[i] = random.symmetric();
    return x;
}

/// Replaces every value by `change(value)`.
template <class Change>
Matrix changed(Matrix x, const Change& change) {
    for (std::int64_t i = 0; i < x.rows() * x.cols(); ++i)
        x.data()[i] = change(x.data()[i]);
    return x;
}

inline Matrix scaled(Matrix x, double factor) {
    return changed(std::move(x), [factor](double value) { return factor * value; });
}

/// Frames with few different values, so that many distances are equal.
inline Matrix lattice(std::int64_t rows, std::int64_t cols, std::uint64_t seed) {
    return changed(noise(rows, cols, seed), [](double value) { return std::round(1.5 * value); });
}

/// The instruction sets of this machine; prints once what is skipped.
inline const std::vector<Simd>& instruction_sets() {
    static const std::vector<Simd> codes = [] {
        std::vector<Simd> available = {Simd::baseline};
        if (stltsa::widest_simd() == Simd::avx2)
            available.push_back(Simd::avx2);
        else
            print_message("SKIPPED: this machine has no AVX2\n");
        return available;
    }();
    return codes;
}

} // namespace ltsa_testing
