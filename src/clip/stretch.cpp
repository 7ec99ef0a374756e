// SPDX-License-Identifier: BSD-3-Clause
#include "clip/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/names.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

constexpr double most_frames = 1e15;

/// A folder is no clip, and must not hide a stretch of one.
bool is_file(const std::string& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_directory(status);
}

/// "300" or "2.5s", not negative.
std::optional<double> place_in(std::string_view text, bool& in_seconds) {
    in_seconds = text.ends_with('s');
    if (in_seconds)
        text.remove_suffix(1);
    const bool plain = !text.empty() && text.find_first_not_of("0123456789.") == text.npos;
    const auto value = plain ? parse_number(text) : std::nullopt;
    if (!value || !(*value < most_frames) || (!in_seconds && *value != std::floor(*value)))
        return std::nullopt;
    return value;
}

std::optional<Stretch> range_in(std::string_view what) {
    const std::size_t dash = what.find('-');
    if (dash == what.npos || what.size() < 2)
        return std::nullopt;
    Stretch range;
    if (dash > 0) {
        const auto begin = place_in(what.substr(0, dash), range.begin_in_seconds);
        if (!begin)
            return std::nullopt;
        range.begin = *begin;
    }
    if (dash + 1 < what.size()) {
        const auto end = place_in(what.substr(dash + 1), range.end_in_seconds);
        if (!end)
            return std::nullopt;
        range.end = *end;
    }
    return range;
}

/// The 3 of "cycle3".
std::optional<Stretch> numbered(std::string_view what, std::string_view word, Stretch::Kind kind) {
    if (!what.starts_with(word))
        return std::nullopt;
    const auto number = parse_integer(what.substr(word.size()));
    if (!number || *number < 1 || what[word.size()] == '+')
        return std::nullopt;
    Stretch stretch;
    stretch.kind = kind;
    stretch.number = *number;
    return stretch;
}

std::optional<Stretch> label_in(std::string_view what) {
    const auto label = label_of(what);
    if (!label)
        return std::nullopt;
    Stretch stretch;
    stretch.kind = Stretch::Kind::label;
    stretch.number = *label;
    return stretch;
}

} // namespace

std::optional<Stretch> parse_stretch(std::string_view what) {
    if (what == "best" || what == "representative" || kind_of(unit_kinds, what)) {
        Stretch stretch;
        stretch.kind = Stretch::Kind::name;
        stretch.name = what;
        return stretch;
    }
    if (auto label = label_in(what))
        return label;
    if (auto range = range_in(what))
        return range;
    if (auto cycle = numbered(what, "cycle", Stretch::Kind::cycle))
        return cycle;
    if (auto segment = numbered(what, "segment", Stretch::Kind::segment))
        return segment;
    return numbered(what, "repetition", Stretch::Kind::repetition);
}

StretchPath split_stretch(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == text.npos || is_file(text) || !is_file(text.substr(0, colon)))
        return {text, {}};
    return {text.substr(0, colon), text.substr(colon + 1)};
}

Frames frames_of(const Stretch& range, const Clip& clip) {
    if ((range.begin_in_seconds || range.end_in_seconds) && !(clip.fps > 0))
        fail(Status::argument, "seconds need a frame rate, and that of the clip is unknown: count "
                               "frames, or set option fps");
    const auto frame = [&](double place, bool in_seconds) {
        return std::llround(std::min(most_frames, in_seconds ? place * clip.fps : place));
    };
    const Frames found{frame(range.begin, range.begin_in_seconds),
                       range.end < 0 ? clip.frames() : frame(range.end, range.end_in_seconds)};
    if (found.begin >= found.end || found.end > clip.frames())
        fail(Status::argument,
             "frames {} to {}: a stretch must have at least one frame, all within the {} frames of "
             "the clip",
             found.begin, found.end, clip.frames());
    return found;
}

Clip cut(const Clip& clip, const std::vector<Frames>& stretches) {
    Clip result = clip;
    std::int64_t rows = 0;
    for (const Frames& stretch : stretches)
        rows += stretch.count();
    result.values = Matrix::unset(rows, clip.values.cols());
    result.breaks.clear();
    result.events.clear();
    std::int64_t at = 0;
    std::string text;
    for (const Frames& stretch : stretches) {
        if (at > 0)
            result.breaks.push_back(at);
        for (const std::int64_t frame : clip.breaks)
            if (frame > stretch.begin && frame < stretch.end)
                result.breaks.push_back(at + frame - stretch.begin);
        for (Event event : clip.events)
            if (event.frame >= static_cast<double>(stretch.begin) &&
                event.frame < static_cast<double>(stretch.end)) {
                event.frame += static_cast<double>(at - stretch.begin);
                result.events.push_back(std::move(event));
            }
        std::copy_n(clip.values.row(stretch.begin), stretch.count() * clip.values.cols(),
                    result.values.row(at));
        at += stretch.count();
        text += format_text("{}[{}, {})", text.empty() ? "" : ", ", stretch.begin, stretch.end);
    }
    result.notes.push_back(format_text("frames {} of the clip, counted from 0 again", text));
    return result;
}

} // namespace stltsa::clip
