// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/text.hpp"

#include "base/names.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tool {

namespace {

/// Insertions, deletions, substitutions, and exchanges of neighbors (optimal string alignment).
std::size_t edits(std::string_view from, std::string_view to) {
    std::vector<std::vector<std::size_t>> table(from.size() + 1,
                                                std::vector<std::size_t>(to.size() + 1));
    for (std::size_t i = 0; i <= from.size(); ++i)
        for (std::size_t j = 0; j <= to.size(); ++j) {
            std::size_t& least = table[i][j];
            if (i == 0 || j == 0) {
                least = i + j;
                continue;
            }
            least = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1,
                              table[i - 1][j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                least = std::min(least, table[i - 2][j - 2] + 1);
        }
    return table.back().back();
}

} // namespace

std::string hint(std::string_view word, const std::vector<std::string>& names) {
    // The beginning of one name, as some commands take it.
    const auto begins = [&](const std::string& name) { return name.starts_with(word); };
    if (word.find_first_not_of('-') != word.npos && std::ranges::count_if(names, begins) == 1)
        return fmt::format("\nDid you mean {}?", *std::ranges::find_if(names, begins));
    const auto distance = [&](const std::string& name) { return edits(word, name); };
    const auto nearest = std::ranges::min_element(names, {}, distance);
    // One slip in three letters, or else short words turn into others, and at most two.
    const auto letters =
        static_cast<std::size_t>(std::ranges::count_if(word, [](char c) { return c != '-'; }));
    const std::size_t slips = std::min<std::size_t>(letters / 3, 2);
    if (nearest == names.end() || distance(*nearest) > slips)
        return "";
    return fmt::format("\nDid you mean {}?", *nearest);
}

std::string wrapped(std::string_view text, std::size_t columns) {
    std::string lines, line;
    while (!text.empty()) {
        const std::size_t blank = std::min(text.find(' '), text.size());
        const std::string word(text.substr(0, blank));
        text.remove_prefix(std::min(blank + 1, text.size()));
        if (line.empty()) {
            line = word;
        } else if (const std::string longer = line + ' ' + word; characters(longer) <= columns) {
            line = longer;
        } else {
            lines += line + '\n';
            line = word;
        }
    }
    return lines + line;
}

bool ends_in(std::string_view name, std::string_view suffix) {
    const auto small = [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    };
    return name.size() >= suffix.size() &&
           std::ranges::equal(name.substr(name.size() - suffix.size()), suffix, {}, small);
}

std::size_t characters(std::string_view text) {
    const auto first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    return static_cast<std::size_t>(std::ranges::count_if(text, first_byte));
}

std::string one_line(std::string text) {
    // Other control characters are replaced where they are shown.
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;)
        text.replace(at, 1, "\xEF\xBF\xBD");
    return text;
}

std::string shortened(const std::string& text, std::size_t most) {
    const std::size_t count = characters(text), kept = most - 3;
    if (count <= most)
        return text;
    std::string begin, end;
    std::size_t seen = 0; // characters, with this one
    for (const char c : text) {
        seen += characters({&c, 1});
        if (seen <= (kept + 1) / 2)
            begin += c;
        else if (seen > count - kept / 2)
            end += c;
    }
    return begin + "..." + end;
}

std::string label_text(std::int64_t label) {
    return stltsa::letters_of(label);
}

std::string counted(std::int64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

} // namespace tool
