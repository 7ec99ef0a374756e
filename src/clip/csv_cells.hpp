// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace stltsa::clip {

/// The separator that a line of data uses: ; tab , or ' ' for any blanks.
char find_separator(std::string_view line);

/// Cells without blanks and quotes around them. Nothing when a quote is not closed, or more
/// follows it in the cell.
std::optional<std::vector<std::string_view>> split_cells(std::string_view line, char separator);

/// Empty, or one of the words for "no value".
bool is_gap(std::string_view cell);

/// A number; its decimal point may be a comma (then the separator is another).
std::optional<double> parse_cell(std::string_view cell);

} // namespace stltsa::clip
