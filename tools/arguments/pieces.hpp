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

/// The path without a stretch of the clip after it: "walk.bvh" of "walk.bvh:cyclic".
std::string file_of(const std::string& text);

/// "-", perhaps with a stretch after it.
bool is_standard_input(const std::string& text);

/// A piece, parsed but not looked up.
struct PieceText {
    std::string path;
    std::string what; ///< empty: the whole clip
    std::int64_t repeat = 1;
};

/// Throws Failure with Exit::usage. If a file has exactly this name, the piece is that whole clip.
PieceText parse_piece(const std::string& text);

/// The clips of the pieces, each opened once.
class PieceFinder {
  public:
    explicit PieceFinder(const Session& session) : session_(session) {}

    /// One piece, or those of a label.
    std::vector<stltsa::Piece> find(const PieceText& text);
    /// The clip of a path.
    const stltsa::Clip& clip(const std::string& path) { return source(path); }

  private:
    const stltsa::Clip& source(const std::string& path);

    const Session& session_;
    std::map<std::string, stltsa::Clip> sources_;
};

} // namespace tool
