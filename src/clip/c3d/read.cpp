// SPDX-License-Identifier: BSD-3-Clause
// C3D: a header, parameters, and frames of points and analog samples (www.c3d.org).
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "base/checkpoint.hpp"
#include "clip/arrays/arrays.hpp"
#include "clip/arrays/missing_codes.hpp"
#include "clip/c3d/file.hpp"
#include "clip/features/subjects.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

using c3d::File;

constexpr std::int64_t short_range = 65536; ///< of the numbers of the header

/// Where the frames are, and of what.
struct Layout {
    std::size_t points = 0, width = 0; ///< `width`: bytes of a number
    std::size_t begin = 0, frame_size = 0;
    double scale = 1;                   ///< of points that are stored as integers, of two bytes
    std::int64_t first = 1, frames = 0; ///< `first`: number in the recording, from 1
};

/// The whole part of a number; none if no file has so many frames.
std::optional<std::int64_t> frame_number(double number) {
    constexpr double most = 1e15;
    return std::abs(number) < most ? std::optional(static_cast<std::int64_t>(number))
                                   : std::nullopt;
}

/// Two numbers of 16 bits, the lower first.
std::optional<std::int64_t> long_number(const File& file, const char* name) {
    const auto halves = file.parameter(name).numbers;
    return halves.size() < 2 ? std::nullopt : frame_number(halves[0] + short_range * halves[1]);
}

/// Frames that the file says it has, the best statement first. `room`: for so many there are bytes,
/// of which `filled` are not zeros that fill the last block.
std::vector<std::int64_t> stated_frames(const File& file, std::int64_t room, std::int64_t filled) {
    std::vector<std::int64_t> stated;
    const auto start = long_number(file, "trial:actual_start_field"),
               end = long_number(file, "trial:actual_end_field");
    if (start && end && *end > 0 && *end >= *start)
        stated.push_back(*end - *start + 1);
    for (const char* name : {"point:long_frames", "point:frames"})
        if (const auto frames = frame_number(file.number(name)); frames && *frames >= 1)
            stated.push_back(*frames);
    // The numbers of the header begin anew after 65535 or stay there.
    const std::int64_t first = file.word(6), last = file.word(8);
    const std::int64_t counted = (last - first + 1 + short_range) % short_range;
    stated.push_back(counted);
    if (room > counted)
        stated.push_back(last == short_range - 1 ? filled : room - (room - counted) % short_range);
    return stated;
}

/// Of the statements that which fits the bytes, but for a block at the end that is not full.
std::int64_t count_frames(const File& file, const Layout& layout, Clip& clip) {
    const double rotations = file.number("rotation:data_start"); // they follow the points
    std::size_t end = file.size();
    const std::size_t before = layout.begin / c3d::block;
    if (rotations > static_cast<double>(before + 1) && rotations < short_range)
        end = std::min(end, c3d::block * (static_cast<std::size_t>(rotations) - 1));
    const auto bytes = static_cast<std::int64_t>(end - std::min(end, layout.begin));
    const auto size = static_cast<std::int64_t>(layout.frame_size), room = bytes / size;
    // Programs fill the last block with zeros, or add one of them.
    const auto fits = [&](std::int64_t frames) {
        return frames > 0 && frames <= room &&
               bytes - frames * size <= static_cast<std::int64_t>(c3d::block);
    };
    const auto is_empty = [&](std::int64_t frame) {
        const auto at = layout.begin + layout.frame_size * static_cast<std::size_t>(frame);
        return file.text(at, layout.frame_size).find_first_not_of('\0') == std::string_view::npos;
    };
    auto filled = room;
    while (fits(filled - 1) && is_empty(filled - 1))
        --filled;
    const auto stated = stated_frames(file, room, filled);
    if (const auto found = std::ranges::find_if(stated, fits); found != stated.end()) {
        if (*found >= short_range && found + 1 == stated.end())
            clip.notes.push_back(format_text("the header counts to 65535 frames; by its size, the "
                                             "file holds {}",
                                             *found));
        return *found;
    }
    if (stated[0] < 1 || stated[0] > room)
        fail(Status::format,
             "{}: the file holds {} of the {} frames that it states: it was cut off, get the whole "
             "file",
             file.name(), room, stated[0]);
    clip.notes.push_back(format_text("the file states {} frames, which are read, and has bytes for "
                                     "{}",
                                     stated[0], room));
    return stated[0];
}

Layout layout_of(const File& file, Clip& clip) {
    Layout layout;
    layout.points = file.word(2);
    layout.first = file.word(6);
    if (const auto start = long_number(file, "trial:actual_start_field");
        start && *start % short_range == layout.first)
        layout.first = *start;
    const double scale = file.real(12);
    layout.width = scale < 0 ? 4 : 2;
    if (!(scale < 0))
        layout.scale = scale > 0 ? scale : file.number("point:scale");
    if (!(layout.scale > 0))
        fail(Status::format, "{}: damaged: the scale of its points is {:g}", file.name(), scale);
    layout.frame_size = layout.width * (4 * layout.points + file.word(4));
    layout.begin = c3d::block * (std::max<std::size_t>(file.word(16), 1) - 1);
    if (layout.points > 0)
        layout.frames = count_frames(file, layout, clip);
    return layout;
}

/// What follows a count of names; empty if there are none.
std::string list_of(const std::vector<std::string>& names) {
    return names.empty() ? "" : ": " + list_in_quotes(names, 6);
}

/// What the file holds beside points; empty: nothing.
std::string other_contents(const File& file) {
    const auto channels = file.parameter("analog:labels").texts;
    const auto segments = file.parameter("rotation:labels").texts;
    const double analog = file.number("analog:used", file.word(4));
    const double rotations = file.number("rotation:used", static_cast<double>(segments.size()));
    std::string text;
    if (analog > 0)
        text = format_text("{:g} analog channels{}", analog, list_of(channels));
    if (rotations > 0)
        text += format_text("{}rotations of {:g} segments{}", text.empty() ? "" : "; ", rotations,
                            list_of(segments));
    return text;
}

/// Names of the points; those without one get one.
std::vector<std::string> names_of(const File& file, const Layout& layout, Clip& clip) {
    std::vector<std::string> names = file.parameter("point:labels").texts, made_up;
    names.resize(layout.points);
    for (std::size_t p = 0; p < names.size(); ++p)
        if (names[p].empty())
            made_up.push_back(names[p] = format_text("p{}", p + 1));
    if (!made_up.empty())
        clip.notes.push_back(format_text("points without a name in the file are named by their "
                                         "places, {} of {}{}",
                                         made_up.size(), names.size(), list_of(made_up)));
    return names;
}

/// The parameters that list results of a model.
constexpr std::string_view result_kinds[] = {"angles", "forces",  "moments",
                                             "powers", "scalars", "reactions"};

/// Whether the name ends as such results are named: LHipAngles, GroundReactionForce.
bool names_result(std::string_view name) {
    return std::ranges::any_of(result_kinds, [&](std::string_view kind) {
        if (!name.ends_with('s'))
            kind.remove_suffix(1);
        const std::string_view end = name.substr(name.size() - std::min(name.size(), kind.size()));
        return !end.empty() && end[0] >= 'A' && end[0] <= 'Z' && to_lower(end) == kind;
    });
}

/// The points that are positions. Parameters list others, the results of a model.
std::vector<std::size_t> positions_in(const File& file, const std::vector<std::string>& names,
                                      Clip& clip) {
    std::set<std::string> listed;
    for (const std::string_view kind : result_kinds)
        for (const std::string& name : file.parameter(format_text("point:{}", kind)).texts)
            listed.insert(name);
    std::vector<std::size_t> kept;
    std::vector<std::string> left_out;
    for (std::size_t p = 0; p < names.size(); ++p)
        if (listed.contains(names[p]) || names_result(names[p]))
            left_out.push_back(names[p]);
        else
            kept.push_back(p);
    if (!left_out.empty())
        clip.notes.push_back(format_text("left out, as results of a model are not positions: {} "
                                         "of {} points{}",
                                         left_out.size(), names.size(), list_of(left_out)));
    return kept;
}

/// A point is missing if its residual is negative, or if a number is NaN.
void read_point(const File& file, const Layout& layout, std::size_t at, double* point) {
    double numbers[4];
    for (double& number : numbers) {
        number = layout.width == 4 ? file.real(at) : static_cast<std::int16_t>(file.word(at));
        at += layout.width;
    }
    const bool missing = numbers[3] < 0 || std::ranges::any_of(numbers, [](double number) {
                             return std::isnan(number);
                         });
    for (int axis = 0; axis < 3; ++axis)
        point[axis] =
            missing ? std::numeric_limits<double>::quiet_NaN() : numbers[axis] * layout.scale;
}

Matrix read_points(const File& file, const Layout& layout, const std::vector<std::size_t>& kept) {
    Matrix values = Matrix::unset(layout.frames, 3 * std::ssize(kept));
    for (std::int64_t i = 0; i < layout.frames; ++i, checkpoint(4 * values.cols())) {
        const std::size_t frame = layout.begin + static_cast<std::size_t>(i) * layout.frame_size;
        double* point = values.row(i);
        for (const std::size_t p : kept) {
            read_point(file, layout, frame + 4 * layout.width * p, point);
            if (std::any_of(point, point + 3, [](double x) { return std::isinf(x); }))
                fail(Status::not_finite, "{}: frame {}: point {} is infinite", file.name(), i, p);
            point += 3;
        }
    }
    return values;
}

/// Frames a second; 0: unknown.
double rate_in(const File& file, Clip& clip) {
    const auto usable = [](double rate) { return rate >= lowest_fps && rate <= highest_fps; };
    const double header = file.real(20), stated = file.number("point:rate");
    if (!usable(stated))
        return usable(header) ? header : 0;
    if (usable(header) && static_cast<float>(header) != static_cast<float>(stated))
        clip.notes.push_back(format_text("the header says {:g} frames a second, and POINT:RATE "
                                         "{:g}, which is taken",
                                         header, stated));
    return stated;
}

/// Turns points half a turn about another axis than this one.
void turn_over(Matrix& values, int axis) {
    for (std::int64_t i = 0; i < values.rows(); ++i)
        for (double* point = values.row(i); point < values.row(i) + values.cols(); point += 3) {
            point[axis] = -point[axis];
            point[(axis + 1) % 3] = -point[(axis + 1) % 3];
        }
}

/// The axis that points up on the screen of the program that wrote the file, such as "+Z".
void read_up_axis(const File& file, Clip& clip) {
    const auto screen = file.parameter("point:y_screen").texts;
    if (screen.empty() || screen[0].empty())
        return;
    std::string axis = to_lower(screen[0]);
    std::erase_if(axis, [](char c) { return c == '+' || c == '-'; });
    if (axis.size() != 1 || axis[0] < 'x' || axis[0] > 'z')
        return clip.notes.push_back("POINT:Y_SCREEN is " + in_quotes(screen[0]) + ": no axis");
    const int up = axis[0] - 'x';
    clip.up = static_cast<Axis>(up + 1);
    if (screen[0].find('-') == std::string::npos)
        return;
    turn_over(clip.values, up);
    clip.notes.push_back(
        format_text("POINT:Y_SCREEN is {}: turned over, so that {} points up", screen[0], axis));
}

/// Events of the parameters, or else of the header. Their times count from frame 1.
void read_events(const File& file, std::int64_t first, double fps, Clip& clip) {
    constexpr std::size_t key = 298, count = 300, times = 304, names = 396, most = 18;
    auto labels = file.parameter("event:labels").texts;
    auto contexts = file.parameter("event:contexts").texts;
    auto minutes = file.parameter("event:times").numbers; // minutes and seconds of each
    if (labels.empty() && file.word(key) == 12345)
        for (std::size_t i = 0; i < std::min<std::size_t>(file.word(count), most); ++i) {
            const std::string_view name = file.text(names + 4 * i, 4);
            labels.emplace_back(trim(name.substr(0, name.find('\0'))));
            minutes.insert(minutes.end(), {0, file.real(times + 4 * i)});
        }
    contexts.resize(labels.size());
    for (std::size_t i = 0; i < std::min(labels.size(), minutes.size() / 2); ++i)
        if (const double frame = (60 * minutes[2 * i] + minutes[2 * i + 1]) * fps;
            std::isfinite(frame))
            clip.events.push_back({frame - static_cast<double>(first - 1), labels[i], contexts[i]});
    std::ranges::stable_sort(clip.events, {}, &Event::frame);
    const auto outside = std::ranges::count_if(clip.events, [&clip](const Event& event) {
        return event.frame < -0.5 || event.frame >= static_cast<double>(clip.frames()) - 0.5;
    });
    if (outside > 0)
        clip.notes.push_back(format_text("{} of {} events are before the first or after the last "
                                         "frame of the file",
                                         outside, clip.events.size()));
    if (clip.events.size() < labels.size())
        clip.notes.push_back(format_text("{} of {} events have no time in frames, and are left out",
                                         labels.size() - clip.events.size(), labels.size()));
}

/// The subjects that the file states, with what labels of their points begin with.
std::vector<Subject> subjects_in(const File& file) {
    const auto names = file.parameter("subjects:names").texts;
    auto prefixes = file.parameter("subjects:label_prefixes").texts;
    const double used = file.number("subjects:used", static_cast<double>(names.size()));
    prefixes.resize(names.size());
    std::vector<Subject> subjects;
    for (std::size_t s = 0; s < names.size() && static_cast<double>(s) < used; ++s)
        if (!names[s].empty())
            subjects.push_back({names[s], prefixes[s].empty() ? names[s] + ':' : prefixes[s]});
    return subjects;
}

/// Leaves the points of one subject in `points`, and returns their names.
std::vector<std::string> keep_subject(const std::vector<std::string>& names,
                                      const std::string& wanted, const File& file,
                                      std::vector<std::size_t>& points, Clip& clip) {
    std::vector<std::string> labels, chosen_labels;
    for (const std::size_t p : points)
        labels.push_back(names[p]);
    auto chosen = take_subject(clip, labels, wanted, file.name(), subjects_in(file)).points;
    for (std::size_t& i : chosen) {
        chosen_labels.push_back(labels[i]);
        i = points[i];
    }
    points = std::move(chosen);
    return chosen_labels;
}

} // namespace

Clip parse_c3d(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    const File file(bytes, name);
    Clip clip;
    const Layout layout = layout_of(file, clip);
    const auto names = names_of(file, layout, clip);
    auto kept = positions_in(file, names, clip);
    const std::string others = other_contents(file);
    if (kept.empty())
        fail(Status::format, "{}: the file has no points; it holds {}{}{}", name, others,
             others.empty() || names.empty() ? "" : "; ",
             !names.empty()   ? "results of a model" + list_of(names)
             : others.empty() ? "nothing else"
                              : "");
    if (!others.empty())
        clip.notes.push_back("beside the points, not read: " + others);
    const std::vector<std::string> labels = keep_subject(names, options.subject, file, kept, clip);
    clip.fps = rate_in(file, clip);
    clip.space = 3;
    clip.values = read_points(file, layout, kept);
    clip.channel_names = coordinate_names(labels, clip.space);
    drop_missing_codes(clip.values, clip.channel_names, clip.notes);
    read_up_axis(file, clip);
    const auto units = file.parameter("point:units").texts;
    clip.unit = units.empty() ? "" : units[0];
    read_events(file, std::max<std::int64_t>(layout.first, 1),
                clip.fps > 0 ? clip.fps : options.fps.value_or(NAN), clip);
    return clip;
}

} // namespace stltsa::clip
