// SPDX-License-Identifier: BSD-3-Clause
// Pieces of clips as typed: walk.bvh, walk.bvh:120-240, walk.bvh:best*4.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "commands/session.hpp"

namespace tool {

/// A piece, parsed but not looked up.
struct PieceText {
    std::string path;
    std::string what; ///< empty: the whole clip
    std::int64_t repeat = 1;
};

/// Throws Failure with Exit::usage. If a file has exactly this name, the piece is that whole clip.
PieceText parse_piece(const std::string& text);

/// The clips of the pieces, each opened once, and decomposed if a piece names a unit or cycle.
class PieceFinder {
  public:
    explicit PieceFinder(const Session& session) : session_(session) {}

    stltsa::Piece find(const PieceText& text);

  private:
    struct Source {
        stltsa::Clip clip;
        std::optional<stltsa::Decomposition> units; ///< none until needed
    };
    Source& source(const std::string& path);
    const stltsa::Decomposition& units(Source& source);
    stltsa::Interval interval(Source& source, const PieceText& text);

    const Session& session_;
    std::map<std::string, Source> sources_;
};

} // namespace tool
