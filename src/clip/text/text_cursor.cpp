// SPDX-License-Identifier: BSD-3-Clause
#include "clip/text/text_cursor.hpp"

#include <algorithm>

#include "base/checkpoint.hpp"
#include "base/utf8.hpp"

namespace stltsa::clip {
namespace {

bool is_blank(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}
bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}
bool is_brace(char c) {
    return c == '{' || c == '}';
}
char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Not a byte outside UTF-8, nor a control character of ASCII or of Latin-1 (U+0080 to U+009F).
bool is_printable(std::string_view character) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
    if (character.size() == 1)
        return byte(0) >= ' ' && byte(0) <= '~';
    return byte(0) != 0xC2 || byte(1) >= 0xA0;
}

} // namespace

std::string to_lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), lower);
    return result;
}

bool equals_ignoring_case(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

bool starts_with_ignoring_case(std::string_view text, std::string_view prefix) {
    return equals_ignoring_case(text.substr(0, prefix.size()), prefix);
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && is_blank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back()))
        text.remove_suffix(1);
    return text;
}

bool is_utf16(std::string_view bytes) {
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

std::string_view next_word(std::string_view& line, std::string_view separators) {
    const auto separates = [separators](char c) {
        return is_blank(c) || separators.find(c) != separators.npos;
    };
    const auto begin = std::find_if_not(line.begin(), line.end(), separates);
    const auto end = std::find_if(begin, line.end(), separates);
    const std::string_view word(begin, end);
    line = std::string_view(end, line.end());
    return word;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 40; // characters
    std::string result;
    for (std::size_t at = 0, count = 0; at < text.size(); ++count) {
        if (count == longest) {
            result += "...";
            break;
        }
        const std::size_t length = std::max<std::size_t>(utf8_length(text, at), 1);
        const std::string_view character = text.substr(at, length);
        result += is_printable(character) ? character : "?";
        at += length;
    }
    return "'" + result + "'";
}

std::string list_in_quotes(const std::vector<std::string>& names, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
        text += (i == 0 ? "" : ", ") + in_quotes(names[i]);
    if (names.size() > most)
        text += format_text(" and {} more", names.size() - most);
    return text;
}

TextCursor::TextCursor(std::string_view text, std::string name)
    : text_(text), name_(std::move(name)) {
    if (text_.starts_with("\xEF\xBB\xBF"))
        position_ = 3;
    else if (is_utf16(text_))
        fail(Status::format, "the text is UTF-16; save it as UTF-8 or ASCII");
}

void TextCursor::check() {
    if (position_ < next_check_)
        return;
    next_check_ = position_ + bytes_between_checks;
    checkpoint();
}

void TextCursor::skip_blanks() {
    while (position_ < text_.size() && is_blank(text_[position_])) {
        const char c = text_[position_++];
        const bool pair = c == '\r' && position_ < text_.size() && text_[position_] == '\n';
        if (is_line_end(c) && !pair)
            ++line_;
    }
}

std::string_view TextCursor::word() {
    check();
    skip_blanks();
    returned_line_ = line_;
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_blank(text_[position_])) {
        if (is_brace(text_[position_]) && position_ > begin)
            break;
        if (is_brace(text_[position_++]))
            break;
    }
    return text_.substr(begin, position_ - begin);
}

std::string_view TextCursor::rest_of_line(char stop) {
    returned_line_ = line_;
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_line_end(text_[position_]) && text_[position_] != stop)
        ++position_;
    return trim(text_.substr(begin, position_ - begin));
}

std::string_view TextCursor::line() {
    check();
    while (position_ < text_.size()) {
        returned_line_ = line_;
        const std::size_t begin = position_;
        const auto end = static_cast<std::size_t>(
            std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.end(),
                         is_line_end) -
            text_.begin());
        position_ = end + (text_.substr(end).starts_with("\r\n") ? 2 : 1);
        position_ = std::min(position_, text_.size());
        line_ += end < text_.size() ? 1 : 0;
        const std::string_view found = text_.substr(begin, end - begin);
        if (!trim(found).empty())
            return found;
    }
    return {};
}

} // namespace stltsa::clip
