// SPDX-License-Identifier: BSD-3-Clause
// Track Row Column files: markers of motion capture, as OpenSim reads them.
#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "clip/arrays/arrays.hpp"
#include "clip/csv/cells.hpp"
#include "clip/csv/point_columns.hpp"
#include "clip/csv/table.hpp"
#include "clip/csv/time_column.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/points.hpp"
#include "clip/features/subjects.hpp"
#include "clip/opensim/header.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

using Line = std::vector<std::string>;

/// The columns before the markers: the number of the frame, and its time.
constexpr std::size_t before_markers = 2;

/// The number at the beginning: "100 Hz" is 100.
std::optional<double> leading_number(std::string_view text) {
    std::string_view word = next_word(text);
    while (!word.empty() && std::isalpha(static_cast<unsigned char>(word.back())) != 0)
        word.remove_suffix(1);
    return parse_cell(word);
}

/// Whether the line is a row of the table: it begins with the number of a frame.
bool is_row(std::string_view line) {
    const std::string_view rest = trim(line);
    return parse_cell(trim(rest.substr(0, rest.find_first_of(" \t,;")))).has_value();
}

class TrcReader {
  public:
    TrcReader(TextCursor& in, Clip& clip) : in_(in), clip_(clip) {}

    /// Leaves the cursor before the first row.
    TableHead head() {
        if (!starts_with_ignoring_case(trim(in_.line()), "PathFileType"))
            in_.fail(Status::format, "the first line of a TRC file begins with PathFileType");
        for (;;) {
            const std::string_view line = in_.line();
            if (line.empty() || is_row(line))
                in_.fail(Status::format, "there is no line with Frame# and the names of the "
                                         "markers before the rows of numbers");
            const Line cells = header_cells(line);
            if (!cells.empty() && starts_with_ignoring_case(cells[0], "Frame")) {
                take_names(cells);
                break;
            }
            TextCursor ahead = in_; // the values of the keys are numbers
            if (const Line values = header_cells(ahead.line());
                !values.empty() && leading_number(values[0])) {
                for (std::size_t i = 0; i < std::min(cells.size(), values.size()); ++i)
                    said_[to_lower(cells[i])] = values[i];
                in_ = ahead;
            }
        }
        skip_axes();
        clip_.fps = rate();
        return {columns(), true};
    }

    /// Notes what the header says of the rows.
    void compare() {
        clip_.space = 3;
        const auto count = std::ssize(markers_);
        note_other_count(clip_, "NumMarkers", said("nummarkers"), count);
        note_other_count(clip_, "NumFrames", said("numframes"), clip_.values.rows());
        clip_.unit = said("units");
    }

    /// Leaves the markers of one subject.
    void keep_subject(const ReadOptions& options) {
        const auto points = take_subject(clip_, markers_, options.subject, in_.name()).points;
        if (points.size() == markers_.size())
            return;
        std::vector<std::int64_t> columns;
        for (const std::size_t point : points)
            for (std::size_t axis = 0; axis < 3; ++axis)
                columns.push_back(static_cast<std::int64_t>(3 * point + axis));
        keep_columns(clip_, columns);
    }

  private:
    std::string said(const std::string& key) const {
        const auto found = said_.find(key);
        return found == said_.end() ? std::string() : found->second;
    }

    double rate() const {
        const auto rate = leading_number(said("datarate"));
        return rate && *rate >= lowest_fps && *rate <= highest_fps ? *rate : 0;
    }

    /// Each name is above the first of the three columns of its marker; some write one after
    /// another.
    void take_names(const Line& cells) {
        first_ = cells;
        first_.resize(before_markers, "Time");
        bool apart = true;
        for (std::size_t c = before_markers; c < cells.size(); ++c) {
            in_.check_name(cells[c]);
            apart = apart && (cells[c].empty() || (c - before_markers) % 3 == 0);
        }
        for (std::size_t c = before_markers; c < cells.size(); ++c)
            if (apart ? (c - before_markers) % 3 == 0 : !cells[c].empty())
                markers_.push_back(cells[c].empty() ? format_text("{}", markers_.size() + 1)
                                                    : cells[c]);
        name_each_once();
        if (markers_.empty())
            in_.fail(Status::format, "there are no names of markers after {} and {}",
                     in_quotes(first_[0]), in_quotes(first_[1]));
    }

    /// Some repeat the name above each of the three columns, perhaps with its axis.
    void name_each_once() {
        const auto count = parse_integer(said("nummarkers"));
        const std::int64_t names = std::ssize(markers_);
        if (!count || names % 3 != 0 || *count != names / 3)
            return;
        Line once;
        for (std::size_t c = 0; c < markers_.size(); c += 3) {
            const std::string point = coordinate_of(markers_[c], AxisPlace::last).point;
            once.push_back(point.empty() ? markers_[c] : point);
        }
        markers_ = std::move(once);
    }

    /// X1 Y1 Z1 X2 ...
    void skip_axes() {
        TextCursor ahead = in_;
        if (const std::string_view line = ahead.line(); !line.empty() && !is_row(line))
            in_ = ahead;
    }

    std::vector<std::string> columns() const {
        std::vector<std::string> names = first_;
        const std::vector<std::string> coordinates = coordinate_names(markers_, 3);
        names.insert(names.end(), coordinates.begin(), coordinates.end());
        return names;
    }

    TextCursor& in_;
    Clip& clip_;
    std::map<std::string, std::string> said_; ///< by keys in lower case
    Line first_;                              ///< names of the columns before the markers
    Line markers_;
};

/// TRC files do not name their axes.
void take_up(Clip& clip) {
    const Axis guess = points_up(clip);
    clip.up = Axis::y;
    std::string text = "up axis: y, as OpenSim has it in TRC files";
    if (guess != Axis::none && guess != clip.up)
        text += format_text(", although {} seems to be up: if {} is up, set option up_axis",
                            "xyz"[static_cast<std::size_t>(guess) - 1],
                            "xyz"[static_cast<std::size_t>(guess) - 1]);
    clip.notes.push_back(text);
}

} // namespace

Clip parse_trc(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    TextCursor in(bytes, name);
    Clip clip;
    TrcReader reader(in, clip);
    TableHead head = reader.head();
    const TableFacts facts = read_rows(in, clip, std::move(head), options);
    reader.compare();
    extract_time(clip, facts, name, options);
    reader.keep_subject(options);
    take_up(clip);
    return clip;
}

} // namespace stltsa::clip
