// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip {

/// The separator of a line of data: ; tab , or ' ' for any blanks.
char find_separator(std::string_view line);

/// The cells, without surrounding blanks and quotes. Empty if a quote is not closed, or is followed
/// by more text in the cell.
std::optional<std::vector<std::string_view>> split_cells(std::string_view line, char separator);

/// The text of a cell: a doubled quote stands for one.
std::string text_of(std::string_view cell);

/// Whether the cell is empty, or one of the words for "no value".
bool is_gap(std::string_view cell);

/// A number; its decimal point may be a comma if that is not the separator.
std::optional<double> parse_cell(std::string_view cell);

} // namespace stltsa::clip
