// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/headers.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include "clip/csv/cells.hpp"
#include "clip/csv/date_time.hpp"
#include "clip/csv/subject_rows.hpp"
#include "clip/csv/time_column.hpp"
#include "clip/csv/time_names.hpp"
#include "clip/features/point_names.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

using Line = std::vector<std::string>; ///< its cells

/// Numbers begin within so many lines, or there is no preamble.
constexpr std::size_t most_lines = 64;

bool is_filled(const std::string& cell) {
    return !cell.empty();
}

std::int64_t filled(const Line& cells) {
    return std::ranges::count_if(cells, is_filled);
}

/// Columns that may have the label of a line.
std::ptrdiff_t label_columns(std::size_t columns) {
    return columns > 3 ? 2 : 0;
}

/// Filled cells, or all but the label of the line.
bool is_all(const Line& cells, bool (*holds)(std::string_view)) {
    return std::all_of(cells.begin() + label_columns(cells.size()), cells.end(),
                       [holds](const std::string& cell) { return cell.empty() || holds(cell); });
}

bool is_unit(std::string_view cell) {
    constexpr std::string_view units[] = {"hz", "n/a", "unit", "%"};
    return is_length_unit(cell) || is_other_unit(cell) || is_time_unit(cell) ||
           std::ranges::any_of(
               units, [cell](std::string_view u) { return equals_ignoring_case(cell, u); });
}

/// "Position", "Position", ... of each column: they tell no columns apart.
bool is_constant(const Line& cells) {
    for (std::size_t c = 3; c < cells.size(); ++c)
        if (cells[c] != cells[2] && !cells[c].empty())
            return false;
    return cells.size() > 3;
}

/// Whether one of the first two columns has a label of which this holds.
template <class Holds>
bool is_labelled(const Line& cells, Holds holds) {
    return std::any_of(cells.begin(),
                       cells.begin() + std::min<std::ptrdiff_t>(2, std::ssize(cells)), holds);
}

/// Whether it says what its cells are, beside its names.
bool has_label(const Line& cells) {
    return !cells[0].empty() || (!cells[1].empty() && cells[1] != cells[2]);
}

/// Numbers and kinds that a system gives its markers; the name of the network that tracked.
bool is_beside_names(const Line& cells) {
    return is_labelled(cells, [](std::string_view cell) {
        constexpr std::string_view labels[] = {"id", "parent", "type", "scorer"};
        return std::ranges::any_of(
            labels, [cell](std::string_view label) { return equals_ignoring_case(cell, label); });
    });
}

/// "X", or the "X1" of some programs, which number the points.
bool is_numbered_axis(std::string_view cell) {
    return is_axis(cell.substr(0, 1)) && cell.find_first_not_of("0123456789", 1) == cell.npos;
}

/// A name stands above the first of its columns.
void spread_names(Line& cells) {
    for (std::size_t c = 1; c < cells.size(); ++c)
        if (cells[c].empty())
            cells[c] = cells[c - 1];
}

class HeadReader {
  public:
    explicit HeadReader(TextCursor& in) : in_(in) {}

    std::optional<Head> read() {
        TextCursor from = in_;
        const bool skipped = find_trajectories(from);
        if (!collect(from))
            return std::nullopt;
        Head head;
        head.separator = separator_;
        find_rate(head);
        find_unit(head);
        if (!take_marker_names(head)) {
            std::vector<Line> levels = levels_of();
            if (levels.empty())
                return std::nullopt;
            set_names(levels, head);
        }
        if (skipped)
            head.notes.emplace_back("section Trajectories read, the sections before it are not");
        if (first_level_ > 0)
            head.notes.push_back(
                format_text("{} lines before the header are not read", first_level_));
        in_ = after_;
        return head;
    }

  private:
    /// Vicon writes sections; that of the markers is wanted.
    static bool find_trajectories(TextCursor& from) {
        constexpr std::string_view sections[] = {"joints", "segments", "model outputs", "devices"};
        const auto title = [](std::string_view line) {
            while (!line.empty() &&
                   (line.back() == ',' || line.back() == ';' || line.back() == '"'))
                line.remove_suffix(1);
            return to_lower(trim(line.starts_with('"') ? line.substr(1) : line));
        };
        TextCursor at = from;
        if (std::ranges::find(sections, title(at.line())) == std::end(sections))
            return false;
        for (TextCursor before = at;; before = at) {
            const std::string_view line = at.line();
            if (line.empty())
                return false;
            if (title(line) == "trajectories") {
                from = before;
                return true;
            }
        }
    }

    static Line split(std::string_view line, char separator) {
        const auto cells = split_cells(line, separator);
        Line line_cells;
        if (cells)
            std::ranges::transform(*cells, std::back_inserter(line_cells), text_of);
        return line_cells;
    }

    static bool is_data(const Line& cells) {
        const auto is_number = [](const std::string& cell) {
            return parse_cell(cell) || parse_date_time(cell);
        };
        return std::ranges::any_of(cells, is_number) &&
               std::ranges::all_of(
                   cells, [&](const std::string& cell) { return is_gap(cell) || is_number(cell); });
    }

    /// Collects the lines before two rows of numbers of equal length.
    bool collect(TextCursor& from) {
        std::vector<std::string_view> lines;
        std::vector<TextCursor> before;
        while (lines.size() < most_lines) {
            before.push_back(from);
            const std::string_view line = from.line();
            if (line.empty())
                return false;
            lines.push_back(line);
            if (lines.size() < 3)
                continue;
            const std::string_view first = lines[lines.size() - 2];
            const char separator = find_separator(first);
            const Line cells = split(first, separator), next = split(line, separator);
            if (cells.size() < 2 || cells.size() != next.size() || !is_data(cells) ||
                !is_data(next))
                continue;
            separator_ = separator;
            columns_ = cells.size();
            // A point that is missing lacks more than the last cell.
            rows_end_open_ = cells.back().empty() && !cells[columns_ - 2].empty();
            after_ = before[lines.size() - 2];
            for (std::size_t i = 0; i + 2 < lines.size(); ++i)
                lines_.push_back(split(lines[i], separator));
            return lines_.size() > 1;
        }
        return false;
    }

    /// A line with a number only, such as that after "Trajectories", or the number after "...
    /// rate", in the next cell or, as in "# fps: 30", in the same one.
    void find_rate(Head& head) const {
        const auto take = [&](std::string_view cell) {
            const auto rate = parse_cell(next_word(cell)); // "30 Hz"
            if (rate && is_plausible_rate(*rate) && head.fps == 0)
                head.fps = *rate;
        };
        for (const Line& cells : lines_) {
            if (cells.size() >= columns_ && filled(cells) > 2)
                continue;
            if (filled(cells) == 1)
                take(cells[0]);
        }
        // The rate of the rows is the exported one; that of analog channels is another one.
        for (const std::string_view wanted : {"export", ""})
            for (const Line& cells : lines_)
                for (std::size_t c = 0; c < cells.size(); ++c) {
                    const std::string_view cell = cells[c];
                    const std::size_t end = cell.find_first_of(":=");
                    if (!is_rate(cell.substr(0, end), wanted))
                        continue;
                    if (end != cell.npos)
                        take(cell.substr(end + 1));
                    if (c + 1 < cells.size())
                        take(cells[c + 1]);
                }
        if (head.fps > 0)
            head.notes.push_back(
                format_text("{:g} frames a second from the lines before the header", head.fps));
    }

    static bool is_rate(std::string_view label, std::string_view wanted) {
        constexpr std::string_view words[] = {"rate", "frequency", "fps", "frames per second"};
        const std::string text = to_lower(label);
        return text.find(wanted) != text.npos && text.find("analog") == text.npos &&
               std::ranges::any_of(
                   words, [&](std::string_view word) { return text.find(word) != text.npos; });
    }

    /// The unit of length of a preamble, such as "Length Units,Meters".
    void find_unit(Head& head) const {
        for (const Line& cells : lines_)
            for (std::size_t c = 0; c + 1 < cells.size(); ++c)
                if (to_lower(cells[c]).find("unit") != std::string::npos &&
                    is_length_unit(cells[c + 1]))
                    return note_unit(cells[c + 1], head);
    }

    static void note_unit(const std::string& unit, Head& head) {
        head.notes.push_back("unit of length in the lines before the numbers: " + unit);
    }

    /// Qualisys without a header of columns: a line has the name of each marker once, and rows may
    /// begin with a frame number and a time.
    bool take_marker_names(Head& head) const {
        const auto line = std::ranges::find_if(lines_, [](const Line& cells) {
            return is_labelled(cells, [](std::string_view cell) {
                return equals_ignoring_case(cell, "marker_names");
            });
        });
        if (line == lines_.end() || lines_.back().size() == columns_)
            return false;
        const auto markers = static_cast<std::size_t>(
            std::find_if_not(line->begin() + 1, line->end(), is_filled) - line->begin() - 1);
        const std::size_t columns = columns_ - (rows_end_open_ ? 1 : 0);
        const std::size_t before = columns - std::min(columns, 3 * markers);
        if (before + 3 * markers != columns || before > 2)
            in_.fail(Status::format,
                     "the line MARKER_NAMES has {} names, but the rows have {} columns: expected "
                     "3 for each name, perhaps after a frame number and a time",
                     markers, columns_);
        head.names = {"Frame", "Time"};
        head.names.resize(before);
        for (std::size_t c = 0; c < 3 * markers; ++c)
            head.names.push_back((*line)[1 + c / 3] + '_' + "xyz"[c % 3]);
        return true;
    }

    /// Whether the line is as wide as the rows: it reaches at least to the last group of three.
    bool is_wide(const Line& cells) const {
        return cells.size() + 2 >= columns_ && cells.size() <= columns_ + 1;
    }

    /// Whether it names columns, and not just itself.
    bool can_be_level(const Line& cells) const {
        if (!is_wide(cells) || has_pairs(cells))
            return false;
        const std::ptrdiff_t labels = label_columns(cells.size());
        return filled(cells) >= (labels > 0 ? 1 : 2) &&
               std::any_of(cells.begin() + labels, cells.end(), is_filled);
    }

    /// Labels and values by turns, such as "Format Version,1.23,Take Name,walk".
    static bool has_pairs(const Line& cells) {
        return cells.size() > 3 && !parse_cell(cells[0]) && parse_cell(cells[1]) &&
               !parse_cell(cells[2]) && !cells[2].empty();
    }

    bool has_units(const Line& cells) const {
        return can_be_level(cells) && is_all(cells, is_unit) && !is_beside_names(cells);
    }

    /// Whether it could, but all its columns are empty, as those of "Parent" may be.
    bool is_empty_level(const Line& cells) const {
        return is_wide(cells) && !can_be_level(cells) && filled(cells) == 1;
    }

    /// The lines that name columns, from above.
    std::vector<Line> levels_of() {
        std::size_t end = lines_.size();
        if (filled(lines_[end - 1]) == 1 && !lines_[end - 1][0].empty() && end > 1)
            index_name_ = lines_[--end][0]; // pandas: the name of the index
        const auto has_number = [](const std::string& cell) {
            return parse_cell(cell).has_value();
        };
        if (!can_be_level(lines_[end - 1]) || std::ranges::any_of(lines_[end - 1], has_number))
            return {};
        first_level_ = end;
        for (std::size_t i = end; i > 0; --i)
            if (can_be_level(lines_[i - 1]))
                first_level_ = i - 1;
            else if (!is_empty_level(lines_[i - 1]))
                break;
        std::vector<Line> levels, constant;
        for (std::size_t i = first_level_; i < end; ++i) {
            Line cells = lines_[i];
            cells.resize(columns_);
            if (!can_be_level(lines_[i]))
                continue;
            const bool is_last = i + 1 == end || has_units(lines_[i + 1]);
            if (has_units(cells) && !levels.empty())
                units_ = std::move(cells);
            else if (!is_last && is_constant(cells) && !has_label(cells))
                constant.push_back(std::move(cells));
            else if (is_last || !is_beside_names(cells))
                levels.push_back(std::move(cells));
        }
        if (levels.size() == 1 && !constant.empty()) // a single marker
            levels.insert(levels.begin(), std::move(constant.front()));
        return levels;
    }

    /// Whether the column may be an index, which has the titles of the lines above.
    bool has_titles(const std::vector<Line>& levels, std::size_t c) const {
        const Line& top = levels.front();
        return c < 2 && levels.size() > 1 && columns_ > 2 && top[c] != top[c == 0 ? 1 : 2] &&
               !(c == 1 && (top[c] == top[0] || is_numbered_axis(top[c])));
    }

    /// The name of an index.
    static std::string title_of(const std::vector<Line>& levels, std::size_t c) {
        if (!levels.back()[c].empty())
            return levels.back()[c];
        std::string name; // "Time" may be above an empty cell
        for (const Line& level : levels)
            if (name.empty() && (time_name(level[c]) || is_counter_name(level[c])))
                name = level[c];
        return name;
    }

    /// The names of all lines, one after another.
    static std::string joined_name(const std::vector<Line>& levels, std::size_t c,
                                   std::vector<Subject>& subjects) {
        std::string name;
        char between = '_';
        for (const Line& level : levels) {
            if (level[c].empty())
                continue;
            if (!name.empty())
                name += between;
            name += !name.empty() && is_numbered_axis(level[c]) ? level[c].substr(0, 1) : level[c];
            const bool is_subject = is_labelled(level, names_subject);
            between = is_subject ? ':' : '_';
            if (is_subject && (subjects.empty() || subjects.back().name != level[c]))
                subjects.push_back({level[c], name + between});
        }
        return name;
    }

    void set_names(std::vector<Line>& levels, Head& head) const {
        for (std::size_t l = 0; l + 1 < levels.size(); ++l)
            spread_names(levels[l]);
        const Line& last = levels.back();
        for (std::size_t c = 0; c < columns_; ++c)
            head.names.push_back(has_titles(levels, c) ? title_of(levels, c)
                                                       : joined_name(levels, c, head.subjects));
        set_units(head);
        if (equals_ignoring_case(last[0], "coords")) // DeepLabCut: above the frame numbers
            head.names[0].clear();
        if (!index_name_.empty())
            head.names[0] = index_name_;
    }

    /// Units of other quantities stay with the names; the unit of positions is that of a note.
    void set_units(Head& head) const {
        std::string length;
        for (std::size_t c = 0; c < units_.size(); ++c) {
            const std::string& unit = units_[c];
            if (is_length_unit(unit))
                length = length.empty() ? unit : length;
            else if (!unit.empty() && !is_gap(unit))
                head.names[c] += " (" + unit + ')';
        }
        if (!length.empty())
            note_unit(length, head);
    }

    TextCursor& in_;
    std::vector<Line> lines_; ///< before the numbers
    Line units_;              ///< of the columns; may be empty
    TextCursor after_ = in_;  ///< before the first row of numbers
    std::size_t columns_ = 0;
    bool rows_end_open_ = false; ///< with a separator
    std::size_t first_level_ = 0;
    char separator_ = ',';
    std::string index_name_;
};

} // namespace

std::optional<Head> read_head(TextCursor& in) {
    return HeadReader(in).read();
}

} // namespace stltsa::clip
