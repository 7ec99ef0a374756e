// SPDX-License-Identifier: BSD-3-Clause
#include "results/synthesized.hpp"

namespace stltsa::results {

Synthesized synthesize(const std::vector<synthesis::Piece>& pieces,
                       const synthesis::Options& options, const Progress& progress) {
    Synthesized made{synthesis::synthesize(pieces, options, progress), options, {}};
    for (const synthesis::Piece& piece : pieces)
        made.pieces.push_back({piece.clip->path, piece.begin, piece.end, piece.repeat});
    return made;
}

} // namespace stltsa::results
