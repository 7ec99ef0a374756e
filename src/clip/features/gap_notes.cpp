// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/gap_notes.hpp"

#include <algorithm>

#include "clip/features/point_names.hpp"
#include "clip/features/strays.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Its name, or its number from 1 if the columns have no such names.
std::string name_of(const Clip& clip, int width, std::int64_t group) {
    const auto column = static_cast<std::size_t>(width * group);
    if (column >= clip.channel_names.size() || clip.channel_names[column].empty())
        return format_text("{}", group + 1);
    const std::string& name = clip.channel_names[column];
    if (width == 1)
        return in_quotes(name);
    if (width == 3 && !names_coordinate(clip.channel_names, column))
        return format_text("{}", group + 1);
    return in_quotes(point_name(name));
}

/// The names of the first groups, and the number of the others.
std::string listed(const Clip& clip, int width, const std::vector<std::int64_t>& groups) {
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, groups.size()); ++i)
        text += (i == 0 ? "" : ", ") + name_of(clip, width, groups[i]);
    if (groups.size() > most)
        text += format_text(" and {} more", groups.size() - most);
    return text;
}

std::string how_filled(GapRule rule, const Gaps& gaps) {
    std::string others = "from the others in the same frame";
    if (rule == GapRule::skip)
        return others;
    const std::string over_time = "linearly over time";
    return gaps.predicted.empty()
               ? over_time
               : over_time + format_text(" up to {} s, beyond that ", longest_filled_s) + others;
}

} // namespace

void note_gaps(const Clip& clip, int width, GapRule rule, const Gaps& gaps,
               std::vector<std::string>& notes) {
    const std::string_view groups = width > 1 ? "points" : "columns";
    const std::string_view missing =
        width > 1 ? "missing (at 0 or without a value)" : "without a value";
    if (gaps.seen.empty())
        fail(Status::not_finite, "all {} are {} in more than half of the frames", groups, missing);
    if (rule == GapRule::refuse && !gaps.holes.empty())
        fail(Status::not_finite,
             "frames {} to {}: most {} are {}; to accept this set option gaps to fill or skip",
             gaps.holes.front().begin, gaps.holes.front().end - 1, groups, missing);
    if (rule == GapRule::refuse && (!gaps.filled.empty() || !gaps.dropped.empty()))
        fail(Status::not_finite,
             "{} {} in some frames, {} values in all: {}; to accept them set option gaps to fill "
             "or skip",
             groups, missing, gaps.frames,
             listed(clip, width, gaps.filled.empty() ? gaps.dropped : gaps.filled));
    if (!gaps.filled.empty())
        notes.push_back(format_text("{} {} in some frames, filled {}: {} ({} in all)", groups,
                                    missing, how_filled(rule, gaps),
                                    listed(clip, width, gaps.filled), gaps.frames));
    if (!gaps.dropped.empty())
        notes.push_back(format_text("{} {} in more than half of the frames that show the body, "
                                    "left out: {}",
                                    groups, missing, listed(clip, width, gaps.dropped)));
    for (const Frames& hole : gaps.holes)
        notes.push_back(
            format_text("frames {} to {}: most {} are missing, so no motion is found there",
                        hole.begin, hole.end - 1, groups));
}

void note_strays(const Clip& clip, int width, const std::vector<std::int64_t>& frames,
                 std::vector<std::string>& notes) {
    std::vector<std::int64_t> points;
    std::int64_t all = 0;
    for (std::int64_t point = 0; point < std::ssize(frames); ++point)
        if (const std::int64_t count = frames[static_cast<std::size_t>(point)]; count > 0) {
            points.push_back(point);
            all += count;
        }
    if (!points.empty())
        notes.push_back(format_text("points that jump away and back within {} s, taken as missing "
                                    "there: {} ({} in all)",
                                    longest_stray_s, listed(clip, width, points), all));
}

} // namespace stltsa::clip
