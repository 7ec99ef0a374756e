// SPDX-License-Identifier: BSD-3-Clause
// A spreadsheet evaluates a cell of a CSV file, even a quoted one, if its text begins like a
// formula. =HYPERLINK(..) as the name of a joint would run with the rights of the user who opens
// the table.
#pragma once

#include <string>
#include <string_view>

namespace stltsa {

/// Whether the text begins like a formula, perhaps after apostrophes.
inline bool is_formula(std::string_view text) {
    const std::size_t first = text.find_first_not_of('\'');
    return first != text.npos && std::string_view("=+-@\t\r").find(text[first]) != text.npos;
}

/// The text, preceded by an apostrophe if it would be a formula, so that spreadsheets show it as
/// text.
inline std::string text_cell(std::string_view text) {
    return (is_formula(text) ? "'" : "") + std::string(text);
}

/// A cell of a CSV file: in quotes if it needs them (RFC 4180) or would where semicolons or tabs
/// separate cells, and never a formula. The pages and Python have the same rule.
inline std::string csv_cell(std::string_view text) {
    const std::string cell = text_cell(text);
    if (cell.find_first_of(",;\t\"\n\r") == cell.npos)
        return cell;
    std::string quoted = "\"";
    for (const char c : cell)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

/// The text that was given to text_cell().
inline std::string_view without_apostrophe(std::string_view cell) {
    return cell.starts_with('\'') && is_formula(cell) ? cell.substr(1) : cell;
}

} // namespace stltsa
