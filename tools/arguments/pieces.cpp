// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arguments/choices.hpp"
#include "arguments/number.hpp"
#include "exit_status.hpp"

namespace tool {
namespace {

[[noreturn]] void no_piece(const std::string& text, std::string_view why) {
    throw Failure(Exit::usage,
                  fmt::format("'{}': {}; a piece is CLIP[:STRETCH][*TIMES]", text, why));
}

/// A folder is no clip, and must not hide a stretch of one.
bool is_file(const std::string& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_directory(status);
}

} // namespace

std::string file_of(const std::string& text) {
    return is_file(text) ? text : text.substr(0, text.rfind(':'));
}

bool is_standard_input(const std::string& text) {
    return file_of(text) == "-";
}

PieceText parse_piece(const std::string& text) {
    PieceText piece{text, "", 1};
    if (is_file(text))
        return piece;
    if (const std::size_t star = text.rfind('*'); star != text.npos) {
        const auto times = number_in<std::int64_t>(std::string_view(text).substr(star + 1));
        if (!times || *times < 1)
            no_piece(text, "the number after * must be at least 1");
        piece.repeat = *times;
        piece.path.resize(star);
    }
    const std::string path = file_of(piece.path);
    if (path.size() < piece.path.size())
        piece.what = piece.path.substr(path.size() + 1);
    piece.path = path;
    return piece;
}

const stltsa::Clip& PieceFinder::source(const std::string& path) {
    if (const auto found = sources_.find(path); found != sources_.end())
        return found->second;
    return sources_.emplace(path, session_.open_clip(path)).first->second;
}

std::vector<stltsa::Piece> PieceFinder::find(const PieceText& text) {
    const stltsa::Clip& from = source(text.path);
    if (text.what.empty())
        return {from.piece(0, from.frames(), text.repeat)};
    try {
        std::vector<stltsa::Piece> pieces;
        for (const stltsa::Interval& part : from.find(text.what, session_.options()))
            pieces.push_back(from.piece(part.begin, part.end, text.repeat));
        return pieces;
    } catch (const stltsa::Error& error) {
        throw Failure(stltsa::Error(error.status(),
                                    fmt::format("{}:{}: {}", text.path, text.what, error.what())));
    }
}

} // namespace tool
