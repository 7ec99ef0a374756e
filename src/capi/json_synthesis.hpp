// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "synthesis/synthesis.hpp"

namespace stltsa::capi {

struct PieceFacts {
    std::string path; ///< empty: from memory
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int64_t repeat = 1;
};

struct SynthesisFacts {
    const clip::Clip* clip = nullptr; ///< that was made
    std::span<const PieceFacts> pieces;
    synthesis::Options options; ///< as asked for
    const synthesis::Synthesis* synthesis = nullptr;
};

std::string synthesis_json(const SynthesisFacts& facts);

} // namespace stltsa::capi
