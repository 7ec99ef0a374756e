// SPDX-License-Identifier: BSD-3-Clause
// Spreadsheets compute a cell of a CSV file, also a quoted one, whose text begins like a formula:
// =HYPERLINK(..) in the name of a joint would act in the name of whoever opens the table.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace stltsa {

/// Whether the text begins like a formula, perhaps after apostrophes.
inline bool is_formula(std::string_view text) {
    const std::size_t first = text.find_first_not_of('\'');
    return first != text.npos && std::string_view("=+-@\t\r").find(text[first]) != text.npos;
}

/// The text, after an apostrophe if it would be a formula: spreadsheets then show it as text.
inline std::string text_cell(std::string_view text) {
    return (is_formula(text) ? "'" : "") + std::string(text);
}

/// What text_cell() was given.
inline std::string_view without_apostrophe(std::string_view cell) {
    return cell.starts_with('\'') && is_formula(cell) ? cell.substr(1) : cell;
}

} // namespace stltsa
