// SPDX-License-Identifier: BSD-3-Clause
// New motion, and the pieces that it was made of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "results/decomposed.hpp"
#include "synthesis/synthesis.hpp"

namespace stltsa::results {

struct PieceFacts {
    std::string path; ///< empty: from memory
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int64_t repeat = 1;
};

struct Synthesized {
    synthesis::Synthesis result;
    synthesis::Options options; ///< as asked for
    std::vector<PieceFacts> pieces;
};

/// Throws as synthesis::synthesize().
Synthesized synthesize(const std::vector<synthesis::Piece>& pieces,
                       const synthesis::Options& options);

/// The loop of the most cycles of the clip whose ends meet: see synthesis::longest_loop().
Synthesized synthesize_loop(const clip::Clip& clip, const Decomposed& decomposed,
                            synthesis::Options options);

} // namespace stltsa::results
