// SPDX-License-Identifier: BSD-3-Clause
#include "results/synthesized.hpp"

#include "synthesis/longest_loop.hpp"

namespace stltsa::results {

Synthesized synthesize(const std::vector<synthesis::Piece>& pieces,
                       const synthesis::Options& options) {
    Synthesized made{synthesis::synthesize(pieces, options), options, {}};
    for (const synthesis::Piece& piece : pieces)
        made.pieces.push_back({piece.clip->path, piece.begin, piece.end, piece.repeat});
    return made;
}

namespace {

/// If the ends do not meet, the error says what they are the ends of.
Synthesized made_of(const synthesis::LongestLoop& chosen, const synthesis::Options& options) {
    try {
        return synthesize({chosen.piece}, options);
    } catch (const Error& error) {
        if (error.status() != Status::no_common_posture)
            throw;
        fail(error.status(), "{}; {}", chosen.note, error.what());
    }
}

} // namespace

Synthesized synthesize_loop(const clip::Clip& clip, const Decomposed& decomposed,
                            synthesis::Options options) {
    options.loop = true;
    std::vector<synthesis::CycleFrames> cycles;
    for (const stltsa_part& cycle : decomposed.cycles)
        cycles.push_back({cycle.begin, cycle.end});
    const synthesis::LongestLoop chosen = synthesis::longest_loop(clip, cycles, options);
    Synthesized made = made_of(chosen, options);
    made.result.notes.push_back(chosen.note);
    if (chosen.piece.cycles > 0) {
        synthesis::Loop& loop = *made.result.loop;
        loop.cycles = chosen.piece.cycles;
        loop.source_cycles = static_cast<std::int64_t>(cycles.size());
        loop.coverage = static_cast<double>(loop.cycles) / static_cast<double>(loop.source_cycles);
    }
    return made;
}

} // namespace stltsa::results
