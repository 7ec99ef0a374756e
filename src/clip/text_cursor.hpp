// SPDX-License-Identifier: BSD-3-Clause
// Walks through a text file by words or lines and knows the line it is in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"

namespace stltsa::clip {

/// ASCII only: the keywords of all formats are.
std::string to_lower(std::string_view text);
bool equals_ignoring_case(std::string_view a, std::string_view b);
bool starts_with_ignoring_case(std::string_view text, std::string_view prefix);
std::string_view trim(std::string_view text);
/// By its byte order mark.
bool is_utf16(std::string_view bytes);

/// Splits off the first word of a line; words are separated by blanks or any of `separators`.
std::string_view next_word(std::string_view& line, std::string_view separators = {});

/// A part of the file for an error message: shortened, nothing unprintable.
std::string quoted(std::string_view text);

/// Lines end with \n, \r\n or \r; control characters count as blanks (old files end with Ctrl-Z);
/// a UTF-8 byte order mark is skipped. Refuses text in UTF-16.
class TextCursor {
  public:
    TextCursor(std::string_view text, std::string name);

    /// The next word on this or a later line, a brace being a word of its own; "" at the end.
    std::string_view word();
    /// The rest of this line up to `stop`, trimmed; what follows is left for the next call.
    std::string_view rest_of_line(char stop = '\0');
    /// The rest of this line, or the next line, that is not blank; "" at the end.
    std::string_view line();

    /// Line of what was returned last, from 1.
    std::int64_t line_number() const { return returned_line_; }
    std::size_t bytes_left() const { return text_.size() - position_; }
    const std::string& name() const { return name_; }

    /// Refuses a name of a joint that is longer than any is: names are repeated for each channel
    /// and each child, so that memory would grow with the square of a hostile file.
    void check_name(std::string_view name) const {
        constexpr std::size_t most = 256;
        if (name.size() > most)
            fail(Status::format, "the name {} has {} bytes; at most {} are read", quoted(name),
                 name.size(), most);
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
    void skip_blanks();

    std::string_view text_;
    std::string name_;
    std::size_t position_ = 0;
    std::int64_t line_ = 1;
    std::int64_t returned_line_ = 1;
};

} // namespace stltsa::clip
