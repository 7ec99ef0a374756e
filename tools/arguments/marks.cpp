// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/marks.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "arguments/number.hpp"
#include "arguments/pieces.hpp"
#include "base/formula.hpp"
#include "exit_status.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

std::optional<double> finite_in(std::string_view text) {
    const auto value = number_in<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

struct Place {
    std::optional<double> value; ///< absent: not a number
    bool seconds;                ///< otherwise in frames
};

/// What comes before the first =.
Place place_of(const std::string& mark) {
    std::string_view place = std::string_view(mark).substr(0, mark.find('='));
    const bool seconds = place.ends_with('s');
    if (seconds)
        place.remove_suffix(1);
    return {finite_in(place), seconds};
}

using Row = std::vector<std::string>;

/// The cells of the next row; cells may be quoted as in CSV files.
Row next_row(std::string_view& text, char separator) {
    Row row(1);
    bool quoted = false;
    std::size_t at = 0;
    for (; at < text.size() && (quoted || text[at] != '\n'); ++at) {
        const char c = text[at];
        if (c == '"' && quoted && at + 1 < text.size() && text[at + 1] == '"')
            row.back() += text[++at];
        else if (c == '"')
            quoted = !quoted;
        else if (c == separator && !quoted)
            row.emplace_back();
        else if (c != '\r')
            row.back() += c;
    }
    text.remove_prefix(std::min(at + 1, text.size()));
    return row;
}

/// The first column that has one of the names.
std::optional<std::size_t> column_of(const Row& heading, std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (const auto found = std::ranges::find(heading, name); found != heading.end())
            return static_cast<std::size_t>(found - heading.begin());
    return std::nullopt;
}

/// The cell of a column; `otherwise` if the table has none.
std::string cell_of(const Row& row, std::optional<std::size_t> column,
                    const std::string& otherwise) {
    return column && *column < row.size() ? std::string(stltsa::without_apostrophe(row[*column]))
                                          : otherwise;
}

/// Labels that are in seconds, from the start of the recording.
void check_times(const std::string& path, const std::string& clip, double fps) {
    if (file_of(clip) != clip)
        throw Failure(
            Exit::usage,
            fmt::format("--mark {}: its seconds count from the start of the recording, but "
                        "{} is a stretch of it: give the whole clip, or a table with a "
                        "column clip",
                        path, clip));
    if (!(fps > 0))
        throw Failure(Exit::usage, fmt::format("--mark {}: labels are in seconds, but the frame "
                                               "rate is unknown: give --fps",
                                               path));
}

Marks not_empty(Marks labels, const std::string& path, const std::string& clip) {
    if (labels.empty())
        throw Failure(Exit::unreadable, fmt::format("{}: no labels for the clip {}", path, clip));
    return labels;
}

} // namespace

bool is_label_file(const std::string& mark) {
    const bool file = ends_in(mark, ".c3d") || ends_in(mark, ".csv") || ends_in(mark, ".tsv");
    return file && !(mark.find('=') != mark.npos && place_of(mark).value);
}

Marks labels_in(const std::string& table, const std::string& path, const std::string& clip,
                double fps) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf"; // Excel writes it
    std::string_view rest = table;
    if (rest.starts_with(byte_order_mark))
        rest.remove_prefix(byte_order_mark.size());
    const char separator = rest.substr(0, rest.find('\n')).find('\t') == rest.npos ? ',' : '\t';
    const Row heading = next_row(rest, separator);
    const auto time = column_of(heading, {"onset", "seconds", "Time"});
    const auto name = column_of(heading, {"trial_type", "name", "Behavior"});
    const auto file = column_of(heading, {"clip"}), what = column_of(heading, {"Behavior type"});
    if (!time || !name)
        throw Failure(Exit::unreadable,
                      fmt::format("{}: no labels found: a table of events needs a column of "
                                  "seconds (onset, seconds or Time) and a column of names "
                                  "(trial_type, name or Behavior)",
                                  path));
    check_times(path, file ? file_of(clip) : clip, fps);
    Marks labels;
    while (!rest.empty()) {
        const Row row = next_row(rest, separator);
        if (cell_of(row, file, clip) != clip || cell_of(row, what, "") == "STOP")
            continue;
        const std::string label = cell_of(row, name, "");
        if (const auto seconds = finite_in(cell_of(row, time, "")); seconds && !label.empty())
            labels[label].push_back(*seconds * fps);
    }
    return not_empty(std::move(labels), path, clip);
}

std::string name_of(const stltsa::FileEvent& event) {
    return *event.context == '\0' ? event.label : fmt::format("{} {}", event.context, event.label);
}

Marks labels_in(const std::vector<stltsa::FileEvent>& events, const std::string& path,
                const std::string& clip, double fps) {
    check_times(path, clip, fps);
    Marks labels;
    for (const stltsa::FileEvent& event : events)
        labels[name_of(event)].push_back(event.seconds * fps);
    return not_empty(std::move(labels), path, clip);
}

Marks parse_marks(const std::vector<std::string>& given, double fps) {
    Marks marks;
    for (const std::string& typed : given) {
        const std::size_t sign = typed.find('=');
        const auto [value, seconds] = place_of(typed);
        if (!value || sign == std::string::npos || sign + 1 == typed.size())
            throw Failure(Exit::usage,
                          fmt::format("--mark is given '{}': it takes FRAME=NAME, such as "
                                      "131=strike or 2.5s=strike",
                                      typed));
        if (seconds && !(fps > 0))
            throw Failure(Exit::usage, fmt::format("--mark {}: the frame rate is unknown: give a "
                                                   "frame, or --fps",
                                                   typed));
        marks[typed.substr(sign + 1)].push_back(seconds ? *value * fps : *value);
    }
    return marks;
}

} // namespace tool
