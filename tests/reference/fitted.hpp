// SPDX-License-Identifier: BSD-3-Clause
// The library as its users see it: only through stltsa.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "neighbors.hpp"

namespace reference {

/// The library's results for the features of one clip.
struct Fitted {
    Table<double> coords;            ///< d x frames
    std::vector<double> eigenvalues; ///< lambda_1 = 0, lambda_2, ...
    double error_estimate = 0;
};

/// Calls stltsa_fit in the given mode; throws std::runtime_error with the library's error text.
Fitted fit(const Frames& frames, std::int32_t mode, std::size_t k, std::size_t w, std::size_t d);

/// Features `euler` of every frame of a clip file. `skeleton` is the path of an ASF file or "".
Frames euler_features(const std::string& path, const std::string& skeleton);

} // namespace reference
