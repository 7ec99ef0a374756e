// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "base/formula.hpp"
#include "clip/csv/cells.hpp"
#include "clip/csv/headers.hpp"
#include "clip/csv/point_columns.hpp"
#include "clip/csv/time_column.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

using Cells = std::vector<std::string_view>;

/// 0, 1, 2, ...: the names that pandas gives to unnamed columns.
bool numbers_columns(std::span<const std::string_view> cells) {
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c] != format_text("{}", c))
            return false;
    return !cells.empty();
}

/// `next`: the next row. If it has only integers, 0, 1, 2, ... may be data. Two columns are too
/// few: the points of a circle may begin at 0, 1.
bool is_header(const Cells& cells, const Cells& next) {
    constexpr std::size_t enough_to_count = 3;
    if (cells[0].empty() && numbers_columns(std::span(cells).subspan(1)))
        return true;
    if (cells.size() >= enough_to_count && numbers_columns(cells))
        return std::any_of(next.begin(), next.end(), [](std::string_view cell) {
            return parse_cell(cell) && !parse_integer(cell);
        });
    return std::any_of(cells.begin(), cells.end(),
                       [](std::string_view cell) { return !is_gap(cell) && !parse_cell(cell); });
}

/// The next row that is not a comment.
std::string_view next_row(TextCursor& in) {
    std::string_view line = in.line();
    while (!line.empty() && trim(line)[0] == '#')
        line = in.line();
    return line;
}

class CsvReader {
  public:
    CsvReader(TextCursor& in, Clip& clip, const Progress& progress)
        : in_(in), clip_(clip), polls_(progress, Stage::read, 1) {}

    void read() {
        if (auto head = read_head(in_)) {
            separator_ = head->separator;
            clip_.fps = head->fps;
            clip_.notes = std::move(head->notes);
            clip_.channel_names = std::move(head->names);
            columns_ = clip_.channel_names.size();
            rows_of_section(next_row(in_));
        } else {
            one_header();
        }
        if (rows_ == 0)
            in_.fail(Status::format, "the file has no rows of numbers");
        Matrix values = Matrix::unset(rows_, static_cast<std::int64_t>(columns_));
        for (std::int64_t i = 0; i < rows_; ++i) {
            std::copy_n(values_.data() + i * values.cols(), values.cols(), values.row(i));
            polls_.did(values.cols());
        }
        clip_.values = std::move(values);
    }

  private:
    void one_header() {
        std::string_view line = next_row(in_);
        // A header may contain any characters, so the second line determines the separator.
        TextCursor ahead = in_;
        const std::string_view second = next_row(ahead);
        separator_ = find_separator(second.empty() ? line : second);
        if (!line.empty() && is_header(split(line), data_cells(second))) {
            header(split(line));
            line = next_row(in_);
        }
        for (; !line.empty(); line = next_row(in_))
            row(split(line));
    }

    /// The section ends with the file, or where the next one has its title.
    void rows_of_section(std::string_view line) {
        for (; !line.empty(); line = next_row(in_)) {
            const Cells cells = split(line);
            const auto is_filled = [](std::string_view cell) { return !cell.empty(); };
            if (!parse_cell(cells[0]) && std::ranges::count_if(cells, is_filled) == 1) {
                clip_.notes.push_back(
                    format_text("the rows from {} on are not read", in_quotes(cells[0])));
                return;
            }
            row(cells);
        }
    }

    Cells split(std::string_view line) const {
        auto cells = split_cells(line, separator_);
        if (!cells)
            in_.fail(Status::format, "a quote is not closed at the end of its cell");
        return *std::move(cells);
    }

    /// The cells of a line that will be read, and checked, later.
    Cells data_cells(std::string_view line) const {
        return split_cells(line, separator_).value_or(Cells());
    }

    void header(Cells cells) {
        if (numbers_columns(cells))
            clip_.notes.push_back("the first line (0, 1, 2, ...) numbers the columns: not a frame");
        if (cells.back().empty()) // every line ends with a separator
            cells.pop_back();
        clip_.channel_names.clear();
        for (const std::string_view cell : cells)
            clip_.channel_names.push_back(text_of(without_apostrophe(cell)));
        columns_ = cells.size();
    }

    void row(Cells cells) {
        if (cells.back().empty() && cells.size() == (columns_ == 0 ? cells.size() : columns_ + 1))
            cells.pop_back();
        if (columns_ == 0)
            columns_ = cells.size();
        if (cells.size() != columns_ || columns_ == 0)
            in_.fail(Status::format, "{} cells, but the previous lines have {}", cells.size(),
                     columns_);
        for (std::size_t c = 0; c < columns_; ++c)
            values_.push_back(number(cells[c], c));
        ++rows_;
    }

    double number(std::string_view cell, std::size_t c) {
        const auto value = parse_cell(cell);
        if ((!value || !std::isfinite(*value)) && is_gap(cell)) // "nan" is both
            return std::numeric_limits<double>::quiet_NaN();
        if (!value)
            in_.fail(Status::format, "column {}: {} is not a number", title(c), in_quotes(cell));
        if (!std::isfinite(*value))
            in_.fail(Status::not_finite, "column {} is {}", title(c), *value);
        return *value;
    }

    std::string title(std::size_t c) const {
        const auto& names = clip_.channel_names;
        return names.empty() ? format_text("{}", c + 1)
                             : format_text("{} ({})", c + 1, in_quotes(names[c]));
    }

    TextCursor& in_;
    Clip& clip_;
    PacedPoll polls_;
    char separator_ = ',';
    std::size_t columns_ = 0;
    std::int64_t rows_ = 0;
    std::vector<double> values_;
};

} // namespace

Clip parse_csv(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    TextCursor in(bytes, name, options.progress);
    Clip clip;
    CsvReader reader(in, clip, options.progress);
    reader.read();
    extract_time(clip, name, options);
    take_points(clip, options);
    return clip;
}

} // namespace stltsa::clip
