// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/cells.hpp"

#include <algorithm>
#include <string>

#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

std::size_t skip_blanks(std::string_view line, std::size_t from, char separator) {
    while (from < line.size() && line[from] != separator && is_blank(line[from]))
        ++from;
    return from;
}

/// The next separator; a blank is any of them.
std::size_t find_end(std::string_view line, std::size_t from, char separator) {
    if (separator != ' ')
        return line.find(separator, from);
    while (from < line.size() && !is_blank(line[from]))
        ++from;
    return from < line.size() ? from : line.npos;
}

/// Position of the quote that closes the one before `from`; skips doubled quotes.
std::size_t closing_quote(std::string_view line, std::size_t from) {
    std::size_t quote = line.find('"', from);
    while (quote != line.npos && line.substr(quote).starts_with("\"\""))
        quote = line.find('"', quote + 2);
    return quote;
}

} // namespace

char find_separator(std::string_view line) {
    const bool tabs = trim(line).find('\t') != line.npos && line.find(",\t") == line.npos;
    const char separator = line.find(';') != line.npos   ? ';'
                           : tabs                        ? '\t'
                           : line.find(',') != line.npos ? ','
                                                         : ' ';
    // "1,5 2,5": numbers do not contain blanks, so these are decimal commas; other text, such as a
    // date with a time, does.
    const auto cells = split_cells(line, separator);
    const bool too_long = cells && std::ranges::any_of(*cells, [](std::string_view cell) {
                              return std::ranges::any_of(cell, is_blank);
                          });
    const auto parts = too_long ? split_cells(line, ' ') : std::nullopt;
    const bool blanks = parts && std::ranges::all_of(*parts, [](std::string_view part) {
                            return is_gap(part) || parse_cell(part);
                        });
    return blanks ? ' ' : separator;
}

std::optional<std::vector<std::string_view>> split_cells(std::string_view line, char separator) {
    if (separator == ' ')
        line = trim(line);
    std::vector<std::string_view> cells;
    for (std::size_t begin = 0;;) {
        begin = skip_blanks(line, begin, separator == ' ' ? '\0' : separator);
        std::size_t end = 0;
        if (begin < line.size() && line[begin] == '"') {
            const std::size_t quote = closing_quote(line, begin + 1);
            end = quote == line.npos ? quote : find_end(line, quote, separator);
            if (quote == line.npos || !trim(line.substr(quote + 1, end - quote - 1)).empty())
                return std::nullopt;
            cells.push_back(trim(line.substr(begin + 1, quote - begin - 1)));
        } else {
            end = find_end(line, begin, separator);
            cells.push_back(trim(line.substr(begin, end - begin)));
        }
        if (end == line.npos)
            return cells;
        begin = end + 1;
    }
}

std::string text_of(std::string_view cell) {
    std::string text;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        text += cell[i];
        i += cell.substr(i).starts_with("\"\"") ? 1 : 0;
    }
    return text;
}

bool is_gap(std::string_view cell) {
    constexpr std::string_view words[] = {
        "",  "nan",      "na",        "n/a",  "null",    "none",   "-nan",
        "-", "nan(ind)", "-nan(ind)", "#n/a", "1.#qnan", "-1.#ind"}; // as C writes it on Windows
    return std::any_of(std::begin(words), std::end(words),
                       [cell](std::string_view word) { return equals_ignoring_case(cell, word); });
}

std::optional<double> parse_cell(std::string_view cell) {
    const std::size_t comma = cell.find(',');
    if (comma == cell.npos)
        return parse_number(cell);
    std::string text(cell);
    text[comma] = '.'; // with thousands separators the text is then not a number
    return parse_number(text);
}

} // namespace stltsa::clip
