// SPDX-License-Identifier: BSD-3-Clause
// Reads a text by words or lines and keeps track of the line number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace stltsa::clip {

/// ASCII only, like the keywords of all formats.
std::string to_lower(std::string_view text);
bool equals_ignoring_case(std::string_view a, std::string_view b);
bool starts_with_ignoring_case(std::string_view text, std::string_view prefix);
std::string_view trim(std::string_view text);
/// Whether there is a UTF-16 byte order mark.
bool is_utf16(std::string_view bytes);

/// Splits off the first word of a line; words are separated by blanks or any of `separators`.
std::string_view next_word(std::string_view& line, std::string_view separators = {});

/// Quotes text of a file for an error message: shortened, without unprintable characters.
std::string in_quotes(std::string_view text);
/// The first of the names, each in quotes, and how many more there are.
std::string list_in_quotes(const std::vector<std::string>& names, std::size_t most);

/// Lines end with \n, \r\n or \r; control characters count as blanks (old files end with Ctrl-Z);
/// a UTF-8 byte order mark is skipped. Text in UTF-16 is an error.
class TextCursor {
  public:
    /// There is a checkpoint in each mebibyte.
    TextCursor(std::string_view text, std::string name);

    /// The next word on this or a later line; a brace is a word of its own. "" at the end.
    std::string_view word();
    /// The remainder of this line up to `stop`, trimmed.
    std::string_view rest_of_line(char stop = '\0');
    /// The remainder of this line, or else the next line that is not blank; "" at the end.
    std::string_view line();

    /// Line of the text returned last, from 1.
    std::int64_t line_number() const { return returned_line_; }
    std::size_t bytes_left() const { return text_.size() - position_; }
    const std::string& name() const { return name_; }

    /// Fails if the name of a joint is too long: names are repeated for each channel and each
    /// child, so the memory for a hostile file could grow with the square of its size.
    void check_name(std::string_view name) const {
        constexpr std::size_t most = 256;
        if (name.size() > most)
            fail(Status::format, "the name {} has {} bytes; at most {} are allowed",
                 in_quotes(name), name.size(), most);
    }

    /// Throws an Error with "name:line: " before the text.
    template <class... Args>
    [[noreturn]] void fail(Status status, fmt::format_string<Args...> text, Args&&... args) const {
        fail_at(returned_line_, status, text, std::forward<Args>(args)...);
    }
    template <class... Args>
    [[noreturn]] void fail_at(std::int64_t line, Status status, fmt::format_string<Args...> text,
                              Args&&... args) const {
        stltsa::fail(status, "{}:{}: {}", name_, line,
                     format_text(text, std::forward<Args>(args)...));
    }

  private:
    static constexpr std::size_t bytes_between_checks = 1 << 20; // some milliseconds

    void skip_blanks();
    void check();

    std::string_view text_;
    std::string name_;
    std::size_t position_ = 0;
    std::size_t next_check_ = bytes_between_checks;
    std::int64_t line_ = 1;
    std::int64_t returned_line_ = 1;
};

} // namespace stltsa::clip
