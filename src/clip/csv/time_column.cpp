// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/time_column.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "clip/arrays/even_times.hpp"
#include "clip/csv/point_columns.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Range of plausible rates, wider than those of motion capture.
constexpr double least_rate = 2;
constexpr double most_rate = 1e5;

/// "Time (ms)" -> "timems".
std::string letters_of(std::string_view name) {
    std::string letters = to_lower(name);
    std::erase_if(letters, [](char c) { return c < 'a' || c > 'z'; });
    return letters;
}

/// Seconds per unit of a time column; 0 if the name does not mean time.
double time_unit(std::string_view name) {
    struct Unit {
        std::string_view name;
        double seconds;
    };
    constexpr Unit units[] = {
        {"time", 1},        {"times", 1},         {"timesec", 1},     {"timesecs", 1},
        {"timeseconds", 1}, {"timestamp", 1},     {"t", 1},           {"ts", 1},
        {"seconds", 1},     {"timems", 1e-3},     {"timemsec", 1e-3}, {"tms", 1e-3},
        {"timeus", 1e-6},   {"timestampms", 1e-3}};
    const std::string letters = letters_of(name);
    for (const Unit& unit : units)
        if (letters == unit.name)
            return unit.seconds;
    return 0;
}

bool counts_frames(std::string_view name, bool is_first) {
    constexpr std::string_view words[] = {"frame",      "frames",   "frameno", "framenumber",
                                          "frameindex", "frameidx", "index",   "sample"};
    const std::string letters = letters_of(name);
    return (is_first && trim(name).empty()) ||
           std::find(std::begin(words), std::end(words), letters) != std::end(words);
}

std::vector<double> column_of(const Matrix& values, std::int64_t column) {
    std::vector<double> result;
    for (std::int64_t i = 0; i < values.rows(); ++i)
        result.push_back(values(i, column));
    return result;
}

/// Whether each value is a number; steps between others have no order.
bool is_complete(const std::vector<double>& column) {
    return std::ranges::none_of(column, [](double value) { return std::isnan(value); });
}

/// Whether the column counts frames and is therefore not a channel.
bool take_count(Clip& clip, std::int64_t column) {
    const std::string title = in_quotes(clip.channel_names[static_cast<std::size_t>(column)]);
    const std::vector<double> values = column_of(clip.values, column);
    const bool counts = is_complete(values) && TimeSteps(values).count();
    clip.notes.push_back(
        counts ? format_text("column {} counts frames: not a channel", title)
               : format_text("column {} does not count frames: kept as a channel", title));
    return counts;
}

/// Whether the column is time and therefore not a channel. Its seconds are put into `times`.
bool take_time(Clip& clip, std::int64_t column, double unit, const ReadOptions& options,
               std::vector<double>& times) {
    const std::string title = in_quotes(clip.channel_names[static_cast<std::size_t>(column)]);
    std::vector<double> seconds = column_of(clip.values, column);
    const bool complete = is_complete(seconds);
    const TimeSteps steps(complete ? seconds : std::vector<double>{0, 0});
    if (!(steps.least > 0)) {
        clip.notes.push_back(
            format_text("column {} {}: not taken as time, but kept as a channel unless it is left "
                        "out below",
                        title, complete ? "does not increase" : "has missing values"));
        return false;
    }
    const double rate = rate_of(steps.mean * unit);
    const bool plausible = rate >= least_rate && rate <= most_rate;
    if (!options.fps && !plausible && steps.count())
        return take_count(clip, column);
    if (!options.fps && !plausible) {
        clip.notes.push_back(format_text(
            "column {} as time would give {:.3g} frames a second: kept as a channel; if it is "
            "time, put its unit into the name, as in 'time (ms)', or set option fps",
            title, rate));
        return false;
    }
    for (double& time : seconds)
        time *= unit;
    times = std::move(seconds);
    clip.fps = rate;
    clip.notes.push_back(format_text("column {} is time, not a channel", title));
    return true;
}

/// Whether it repeats the number of another column within a frame, and is therefore not a channel.
bool take_subframe(Clip& clip, std::int64_t column) {
    const std::string& title = clip.channel_names[static_cast<std::size_t>(column)];
    if (letters_of(title) != "subframe")
        return false;
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        if (clip.values(i, column) != clip.values(0, column))
            return false;
    return true;
}

void note_unnamed_time(Clip& clip) {
    const std::vector<double> first = column_of(clip.values, 0);
    if (!is_complete(first))
        return;
    const TimeSteps steps(first);
    if (steps.least > 0 && steps.most - steps.least <= 1e-3 * steps.mean)
        clip.notes.push_back("column 1 increases by equal steps: if it is time or a frame number, "
                             "remove it, or name it so in a header line");
}

} // namespace

void extract_time(Clip& clip, const std::string& name, const ReadOptions& options) {
    if (clip.values.rows() < 2)
        return;
    if (clip.channel_names.empty())
        return note_unnamed_time(clip);
    std::vector<std::int64_t> kept;
    std::vector<double> times;
    for (std::int64_t column = 0; column < clip.values.cols(); ++column) {
        const std::string& title = clip.channel_names[static_cast<std::size_t>(column)];
        const double unit = time_unit(title);
        const bool taken =
            unit > 0 ? take_time(clip, column, unit, options, times)
                     : take_subframe(clip, column) ||
                           (counts_frames(title, kept.empty()) && take_count(clip, column));
        if (!taken)
            kept.push_back(column);
    }
    if (kept.empty())
        fail(Status::format, "{}: there is no channel besides time and frame numbers", name);
    if (std::ssize(kept) < clip.values.cols())
        keep_columns(clip, kept, options.progress);
    if (times.empty())
        return;
    if (options.fps) {
        if (const TimeSteps steps(times); !steps.even())
            clip.notes.push_back(format_text("the steps of time, from {:.6g} to {:.6g} s, are not "
                                             "used: option fps is set",
                                             steps.least, steps.most));
        return;
    }
    EvenRows even = even_rows(std::move(clip.values), times, name);
    clip.values = std::move(even.rows);
    clip.fps = even.fps;
    if (!even.note.empty())
        clip.notes.push_back(std::move(even.note));
}

} // namespace stltsa::clip
