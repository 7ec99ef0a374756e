// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "linalg/pack.hpp"

namespace stltsa::ltsa {

/// Which frames can be neighbors of a frame. Same values as STLTSA_MODE_* (checked in capi).
enum class Mode : std::int32_t {
    temporal = 1,  ///< within +-window frames of the same clip (paper, section 2.1)
    spatial = 2,   ///< among all frames of all clips (classical LTSA)
    recurrent = 3, ///< temporal, plus the `links` nearest frames outside the exclusion zone
};

/// The parameters of a fit; every field is set ("auto" is resolved in results).
struct Parameters {
    std::int64_t neighbors = 12; ///< k, including the frame itself if include_self
    std::int64_t window = 12;    ///< w, frames on each side
    int dimension = 2;           ///< d
    Mode mode = Mode::temporal;
    bool include_self = true;
    std::int64_t links = 4;     ///< recurrent: neighbors from outside the exclusion zone
    std::int64_t exclusion = 0; ///< recurrent: frames on each side that are not links
    int threads = 1;
    Simd simd = widest_simd(); ///< for tests: results are the same for all
};

} // namespace stltsa::ltsa
