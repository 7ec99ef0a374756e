// SPDX-License-Identifier: BSD-3-Clause
// The library as its users see it: through stltsa.h only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "neighbors.hpp"

namespace reference {

/// What the library answers for one clip, features given.
struct Fitted {
    Table<double> coords;            ///< d x frames
    std::vector<double> eigenvalues; ///< lambda_1 = 0, lambda_2, ...
    double error_estimate = 0;
};

/// stltsa_fit in the given mode; throws std::runtime_error with the library's own sentence.
Fitted fit(const Frames& frames, std::int32_t mode, std::size_t k, std::size_t w, std::size_t d);

/// Features `euler` of every frame of a clip file. `skeleton`: path of an ASF, or "".
Frames euler_features(const std::string& path, const std::string& skeleton);

} // namespace reference
