// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

/// Cuts text at blanks into lines that fit; a word that does not fit alone gets its own line.
std::vector<std::string> wrapped(std::string_view text,
                                 const std::function<bool(const std::string& line)>& fits);

/// The same for lines of so many characters, as one text.
std::string wrapped(std::string_view text, std::size_t columns);

/// Whether a name has this suffix, written in small letters; capitals in the name do not matter.
bool ends_in(std::string_view name, std::string_view suffix);

/// A line "Did you mean ...?" for the name that the word is a misspelling of; "" for none.
std::string hint(std::string_view word, const std::vector<std::string>& names);

/// Characters in UTF-8 text.
std::size_t characters(std::string_view text);

/// "1 cycle", "2 cycles".
std::string counted(std::int64_t count, std::string_view noun);

} // namespace tool
