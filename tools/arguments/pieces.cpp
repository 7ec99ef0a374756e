// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/pieces.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arguments/choices.hpp"
#include "exit_status.hpp"

namespace tool {
namespace {

std::vector<std::string> parts() {
    std::vector<std::string> names = unit_names();
    names.insert(names.end(), {"best", "representative"});
    return names;
}

/// The whole text as a nonnegative number.
template <class T>
std::optional<T> number_in(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= T{}))
        return std::nullopt;
    return value;
}

struct Range {
    double begin = 0;
    double end = 0;
    bool seconds = false; ///< else frames
};

/// "120-240" or "1.0s-2.0s".
std::optional<Range> range_in(std::string_view what) {
    const std::size_t dash = what.find('-');
    if (dash == what.npos)
        return std::nullopt;
    std::string_view begin = what.substr(0, dash);
    std::string_view end = what.substr(dash + 1);
    const bool seconds = begin.ends_with('s') && end.ends_with('s');
    if (seconds) {
        begin.remove_suffix(1);
        end.remove_suffix(1);
    }
    const auto first = number_in<double>(begin);
    const auto last = number_in<double>(end);
    const auto whole = [](double value) { return value == std::floor(value) && value < 1e15; };
    if (!first || !last || (!seconds && !(whole(*first) && whole(*last))))
        return std::nullopt;
    return Range{*first, *last, seconds};
}

/// The 3 of "cycle3".
std::optional<std::int64_t> cycle_in(std::string_view what) {
    if (!what.starts_with("cycle"))
        return std::nullopt;
    const auto number = number_in<std::int64_t>(what.substr(5));
    return number && *number > 0 ? number : std::nullopt;
}

bool is_part(std::string_view what) {
    const std::vector<std::string> names = parts();
    return std::ranges::find(names, what) != names.end() || range_in(what) || cycle_in(what);
}

[[noreturn]] void no_piece(const std::string& text, std::string_view why) {
    throw Failure(Exit::usage,
                  fmt::format("'{}': {}; a piece is CLIP[:WHAT][*TIMES], where WHAT is "
                              "120-240, 1.0s-2.0s, cycle3, {}",
                              text, why, fmt::join(parts(), ", ")));
}

bool is_file(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

[[noreturn]] void missing(const PieceText& text, const std::string& reason) {
    throw Failure(Exit::untrustworthy,
                  fmt::format("{}:{}: {} (stltsa decompose lists its units)", text.path, text.what,
                              reason.empty() ? "the clip has no such part" : reason));
}

/// Index of the cycle that is meant; empty for a unit.
std::optional<std::int64_t> cycle_meant(const std::string& what,
                                        const stltsa::Decomposition& units) {
    if (what == "best")
        return units.info().integer(STLTSA_INFO_BEST);
    if (what == "representative")
        return units.info().integer(STLTSA_INFO_REPRESENTATIVE);
    if (const auto number = cycle_in(what))
        return *number - 1;
    return std::nullopt;
}

} // namespace

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
    const std::size_t colon = piece.path.rfind(':');
    if (colon == piece.path.npos || is_file(piece.path))
        return piece;
    piece.what = piece.path.substr(colon + 1);
    piece.path.resize(colon);
    if (!is_part(piece.what))
        no_piece(text, fmt::format("'{}' is not a part of a clip", piece.what));
    return piece;
}

PieceFinder::Source& PieceFinder::source(const std::string& path) {
    if (const auto found = sources_.find(path); found != sources_.end())
        return found->second;
    return sources_.emplace(path, Source{session_.open_clip(path), std::nullopt}).first->second;
}

const stltsa::Decomposition& PieceFinder::units(Source& source) {
    if (!source.units)
        source.units = stltsa::decompose(source.clip, session_.options());
    return *source.units;
}

stltsa::Interval PieceFinder::interval(Source& source, const PieceText& text) {
    const stltsa::Decomposition& all = units(source);
    if (const auto index = cycle_meant(text.what, all)) {
        if (*index < 0 || *index >= all.cycle_count())
            missing(text, all.reason());
        return all.cycle(*index);
    }
    for (const stltsa::Interval& unit : all.units())
        if (stltsa::unit_name(unit.kind) == text.what)
            return unit;
    missing(text, all.reason());
}

stltsa::Piece PieceFinder::find(const PieceText& text) {
    Source& from = source(text.path);
    stltsa::Piece piece = from.clip.piece(0, from.clip.frames(), text.repeat);
    if (text.what.empty())
        return piece;
    if (const auto range = range_in(text.what)) {
        const double scale = range->seconds ? from.clip.fps() : 1;
        const auto frame = [scale](double at) { return std::llround(std::min(at * scale, 1e15)); };
        piece.begin = frame(range->begin);
        piece.end = frame(range->end);
    } else {
        const stltsa::Interval part = interval(from, text);
        piece.begin = part.begin;
        piece.end = part.end;
    }
    return piece;
}

} // namespace tool
