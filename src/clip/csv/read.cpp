// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "base/checkpoint.hpp"
#include "base/formula.hpp"
#include "clip/arrays/missing_codes.hpp"
#include "clip/csv/bids.hpp"
#include "clip/csv/cells.hpp"
#include "clip/csv/date_time.hpp"
#include "clip/csv/headers.hpp"
#include "clip/csv/point_columns.hpp"
#include "clip/csv/subject_rows.hpp"
#include "clip/csv/table.hpp"
#include "clip/csv/time_column.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

using Cells = std::vector<std::string_view>;

bool is_value(std::string_view cell) {
    return parse_cell(cell) || parse_date_time(cell);
}

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
                       [](std::string_view cell) { return !is_gap(cell) && !is_value(cell); });
}

/// The next row that is not a comment.
std::string_view next_row(TextCursor& in) {
    std::string_view line = in.line();
    while (!line.empty() && trim(line)[0] == '#')
        line = in.line();
    return line;
}

/// The first cell, a time or a number of a frame, is never empty.
std::string_view without_indent(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    return line;
}

class CsvReader {
  public:
    CsvReader(TextCursor& in, Clip& clip, const ReadOptions& options)
        : in_(in), clip_(clip), options_(options) {}

    void read() {
        if (!options_.channels.empty()) {
            described_rows();
        } else if (auto head = read_head(in_)) {
            separator_ = head->separator;
            clip_.fps = head->fps;
            clip_.notes = std::move(head->notes);
            subjects_stated_ = std::move(head->subjects);
            clip_.channel_names = std::move(head->names);
            columns_ = clip_.channel_names.size();
            rows_of_section(next_row(in_));
        } else {
            one_header();
        }
        set_values();
    }

    /// The names are given: the file has lines of its own before the rows.
    void read(TableHead head) {
        clip_.channel_names = std::move(head.names);
        columns_ = clip_.channel_names.size();
        may_end_early_ = head.may_end_early;
        may_have_text_ = false;
        std::string_view line = next_row(in_);
        separator_ = find_separator(without_indent(line));
        for (; !line.empty(); line = next_row(in_))
            row(split(without_indent(line)));
        if (short_rows_ > 0)
            clip_.notes.push_back(
                format_text("{} rows end early: their other values are missing", short_rows_));
        set_values();
    }

    TableFacts facts() const {
        TableFacts facts{lines_, {}, subjects_stated_};
        for (std::size_t c = 0; c < dated_.size(); ++c)
            if (dated_[c])
                facts.dated.push_back(static_cast<std::int64_t>(c));
        return facts;
    }

  private:
    void set_values() {
        if (rows_ == 0)
            in_.fail(Status::format, "the file has no rows of numbers");
        refuse_text_only();
        Matrix values = Matrix::unset(rows_, static_cast<std::int64_t>(columns_));
        for (std::int64_t i = 0; i < rows_; ++i) {
            std::copy_n(values_.data() + i * values.cols(), values.cols(), values.row(i));
            checkpoint(values.cols());
        }
        drop_missing_codes(values, clip_.channel_names, clip_.notes);
        clip_.values = std::move(values);
        take_rows_of_subject(clip_, subject_column_, subjects_, lines_, in_.name(), options_);
        drop_text();
    }

    /// Motion-BIDS: another file describes the columns.
    void described_rows() {
        clip_.channel_names = channel_names(options_.channels);
        clip_.notes.push_back("the columns are those of " + options_.channels);
        if (!options_.sidecar.empty())
            clip_.fps = sampling_frequency(options_.sidecar);
        if (clip_.fps > 0)
            clip_.notes.push_back(
                format_text("{:g} frames a second from {}", clip_.fps, options_.sidecar));
        else if (!options_.sidecar.empty())
            clip_.notes.push_back("no valid SamplingFrequency in " + options_.sidecar);
        columns_ = clip_.channel_names.size();
        said_by_ = options_.channels;
        std::string_view line = next_row(in_);
        separator_ = '\t';
        if (!line.empty() && is_header(split(line), {})) {
            clip_.notes.emplace_back("the first line is a header: not read");
            line = next_row(in_);
        }
        for (; !line.empty(); line = next_row(in_))
            row(split(line));
    }

    void one_header() {
        std::string_view line = next_row(in_);
        // A header may contain any characters, so the second line determines the separator.
        TextCursor ahead = in_;
        const std::string_view second = next_row(ahead);
        separator_ = find_separator(second.empty() ? line : second);
        if (!line.empty() && is_header(split(line), data_cells(second))) {
            Cells cells = split(line);
            const Cells below = data_cells(second);
            if (below.size() == cells.size() + 1 && !below.back().empty()) // R: names of the rows
                cells.insert(cells.begin(), std::string_view());
            header(std::move(cells));
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
            if (!is_value(cells[0]) && std::ranges::count_if(cells, is_filled) == 1) {
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
        const auto subject = std::ranges::find_if(clip_.channel_names, names_subject);
        if (subject != clip_.channel_names.end())
            subject_column_ = static_cast<std::size_t>(subject - clip_.channel_names.begin());
    }

    void row(Cells cells) {
        if (cells.back().empty() && cells.size() == (columns_ == 0 ? cells.size() : columns_ + 1))
            cells.pop_back();
        if (columns_ == 0)
            columns_ = cells.size();
        if (may_end_early_ && separator_ != ' ' && cells.size() < columns_)
            pad(cells);
        if (cells.size() != columns_ || columns_ == 0)
            in_.fail(Status::format, "{} cells, but {} {}", cells.size(),
                     said_by_.empty() ? "the previous lines have" : said_by_ + " describes",
                     columns_);
        contents_.resize(columns_);
        dated_.resize(columns_);
        for (std::size_t c = 0; c < columns_; ++c)
            values_.push_back(number(cells[c], c));
        lines_.push_back(in_.line_number());
        if (subject_column_)
            subjects_.push_back(is_gap(cells[*subject_column_]) ? std::string()
                                                                : text_of(cells[*subject_column_]));
        ++rows_;
    }

    /// Of a large table, most cells must be there: short rows below many names would take far more
    /// memory than the file has bytes.
    void pad(Cells& cells) {
        constexpr std::size_t small = 1 << 20;
        padded_ += columns_ - cells.size();
        if (padded_ > small && 2 * padded_ > values_.size())
            in_.fail(Status::format, "most cells are missing: {} of {} columns in this row",
                     columns_ - cells.size(), columns_);
        cells.resize(columns_);
        ++short_rows_;
    }

    /// Seconds, if the cell is a date.
    double number(std::string_view cell, std::size_t c) {
        const auto value = parse_cell(cell);
        if ((!value || !std::isfinite(*value)) && is_gap(cell)) // "nan" is both
            return std::numeric_limits<double>::quiet_NaN();
        if (!value)
            return text(cell, c);
        if (!std::isfinite(*value))
            in_.fail(Status::not_finite, "column {} is {}", title(c), *value);
        if (contents_[c].kind == Content::Kind::text)
            refuse(contents_[c], c);
        contents_[c].kind = Content::Kind::number;
        return *value;
    }

    /// What the cells of a column have been so far.
    struct Content {
        enum class Kind { nothing, number, text } kind = Kind::nothing;
        std::int64_t line = 0; ///< of the first text
        std::string text;
    };

    /// Seconds, or no value: columns of text are left out. A text among numbers is an error.
    double text(std::string_view cell, std::size_t c) {
        const bool is_number = contents_[c].kind == Content::Kind::number;
        if (const auto seconds = parse_date_time(cell)) {
            contents_[c].kind = Content::Kind::number;
            dated_[c] = true;
            return *seconds;
        }
        if (is_number || clip_.channel_names.empty() || !may_have_text_)
            refuse({Content::Kind::text, in_.line_number(), std::string(cell)}, c);
        if (contents_[c].kind == Content::Kind::nothing)
            contents_[c] = {Content::Kind::text, in_.line_number(), std::string(cell)};
        return std::numeric_limits<double>::quiet_NaN();
    }

    [[noreturn]] void refuse(const Content& content, std::size_t c) const {
        in_.fail_at(content.line, Status::format, "column {}: {} is not a number", title(c),
                    in_quotes(content.text));
    }

    void refuse_text_only() const {
        const auto is_text = [](const Content& content) {
            return content.kind == Content::Kind::text;
        };
        if (std::ranges::none_of(contents_, [](const Content& content) {
                return content.kind == Content::Kind::number;
            }))
            if (const auto first = std::ranges::find_if(contents_, is_text);
                first != contents_.end())
                refuse(*first, static_cast<std::size_t>(first - contents_.begin()));
    }

    /// Columns without any number.
    void drop_text() {
        std::vector<std::int64_t> kept;
        std::vector<std::string> names;
        for (std::size_t c = 0; c < columns_; ++c)
            if (contents_[c].kind == Content::Kind::text)
                names.push_back(clip_.channel_names[c]);
            else
                kept.push_back(static_cast<std::int64_t>(c));
        if (names.empty())
            return;
        keep_columns(clip_, kept);
        for (std::size_t c = 0; c < kept.size(); ++c)
            dated_[c] = dated_[static_cast<std::size_t>(kept[c])];
        dated_.resize(kept.size());
        clip_.notes.push_back("columns of text, left out: " + list_in_quotes(names, 20));
    }

    std::string title(std::size_t c) const {
        const auto& names = clip_.channel_names;
        return names.empty() ? format_text("{}", c + 1)
                             : format_text("{} ({})", c + 1, in_quotes(names[c]));
    }

    TextCursor& in_;
    Clip& clip_;
    const ReadOptions& options_;
    char separator_ = ',';
    std::size_t columns_ = 0;
    std::int64_t rows_ = 0;
    std::vector<double> values_;
    std::vector<std::int64_t> lines_; ///< of the rows
    std::vector<Content> contents_;
    std::vector<bool> dated_; ///< columns that have dates
    std::string said_by_;     ///< the file that describes the columns
    std::optional<std::size_t> subject_column_;
    std::vector<std::string> subjects_; ///< of the rows
    std::vector<Subject> subjects_stated_;
    bool may_end_early_ = false;
    bool may_have_text_ = true; ///< columns of text
    std::size_t padded_ = 0;    ///< cells that rows lack at their end
    std::int64_t short_rows_ = 0;
};

} // namespace

TableFacts read_rows(TextCursor& in, Clip& clip, TableHead head, const ReadOptions& options) {
    CsvReader reader(in, clip, options);
    reader.read(std::move(head));
    return reader.facts();
}

Clip parse_csv(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    TextCursor in(bytes, name);
    Clip clip;
    CsvReader reader(in, clip, options);
    reader.read();
    const TableFacts facts = reader.facts();
    extract_time(clip, facts, name, options,
                 [&] { take_points(clip, name, options, facts.subjects); });
    return clip;
}

} // namespace stltsa::clip
