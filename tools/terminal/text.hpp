// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/formula.hpp"

namespace tool {

/// Breaks text at blanks into lines; a word that is too long gets its own line.
std::string wrapped(std::string_view text, std::size_t columns);

using stltsa::csv_cell;

/// Whether a name ends in this lower-case suffix, ignoring case.
bool ends_in(std::string_view name, std::string_view suffix);

/// A line "Did you mean ...?" with the name that the word may misspell; "" if there is none.
std::string hint(std::string_view word, const std::vector<std::string>& names);

/// Number of characters in UTF-8 text.
std::size_t characters(std::string_view text);

/// The text with U+FFFD for each line break: lines are part of tables.
std::string one_line(std::string text);

/// At most so many characters, with ... for those in the middle that are left out.
std::string shortened(const std::string& text, std::size_t most);

/// The label of a segment: A, B, ... Z, AA, AB, ...; empty for -1.
std::string label_text(std::int64_t label);

/// "1 cycle", "2 cycles".
std::string counted(std::int64_t count, std::string_view noun);

} // namespace tool
