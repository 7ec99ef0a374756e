// SPDX-License-Identifier: BSD-3-Clause
#include "reports/table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "arguments/option_flags.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"
#include "terminal/width.hpp"

namespace tool {
namespace {

std::string padded(const std::string& cell, std::size_t width, Align align) {
    const std::string blanks(width - std::min(width, characters(cell)), ' ');
    return align == Align::left ? cell + blanks : blanks + cell;
}

std::string without_trailing_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

/// Wraps the text; further lines are indented to where the text starts.
std::string hanging(const std::string& start, const std::string& text) {
    const std::size_t indent = characters(start);
    constexpr std::size_t narrowest = 20; // beside a long start
    const std::size_t columns = std::max(terminal_columns(STDOUT_FILENO), indent + narrowest);
    std::string result = start;
    for (const char c : wrapped(text, columns - indent)) {
        result += c;
        if (c == '\n')
            result.append(indent, ' ');
    }
    return result + '\n';
}

} // namespace

std::string Table::line_of(const std::vector<std::string>& row,
                           const std::vector<std::size_t>& widths) const {
    constexpr std::size_t indent = 6; // of a remark on lines of its own
    std::string line, before_remark;
    for (std::size_t c = 0; c < row.size(); ++c) {
        if (c + 1 == columns_.size())
            before_remark = line;
        line += "  " + padded(row[c], widths[c], columns_[c]);
    }
    line = without_trailing_blanks(line);
    const bool fits = characters(line) <= terminal_columns(STDOUT_FILENO);
    if (fits || before_remark.empty() || columns_.back() == Align::right)
        return line + '\n';
    return without_trailing_blanks(before_remark) + '\n' +
           hanging(std::string(indent, ' '), row.back());
}

std::string Table::text() const {
    std::vector<std::size_t> widths(columns_.size(), 0);
    for (const auto& row : rows_)
        for (std::size_t c = 0; row.size() > 1 && c < row.size(); ++c)
            widths[c] = std::max(widths[c], characters(row[c]));
    std::string result;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        const std::string line = line_of(rows_[r], widths);
        result += r < heading_rows_ ? dim(line.substr(0, line.size() - 1)) + '\n' : line;
    }
    return result;
}

void Table::fold(std::size_t first_cells) {
    constexpr std::ptrdiff_t shown = 3;
    const auto equal = [&](const auto& one, const auto& other) {
        const auto from = static_cast<std::ptrdiff_t>(first_cells);
        return std::equal(one.begin() + from, one.end(), other.begin() + from, other.end());
    };
    std::vector<std::vector<std::string>> folded(
        rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(heading_rows_));
    for (auto first = rows_.begin() + std::ssize(folded); first != rows_.end();) {
        const auto last = std::find_if_not(first, rows_.end(),
                                           [&](const auto& row) { return equal(*first, row); });
        if (const auto count = last - first; count > shown) {
            folded.push_back(*first);
            folded.push_back({fmt::format("... {} more like these", count - 2)});
            folded.push_back(*(last - 1));
        } else {
            folded.insert(folded.end(), first, last);
        }
        first = last;
    }
    rows_ = std::move(folded);
}

void Facts::add(std::string name, std::string value) {
    facts_.emplace_back(std::move(name), std::move(value));
}

std::string Facts::text() const {
    constexpr std::size_t widest = 40; // longer names, those of files, get a line of their own
    std::size_t width = 0;
    for (const auto& [name, value] : facts_)
        if (characters(name) <= widest)
            width = std::max(width, characters(name));
    std::string result;
    for (const auto& [name, value] : facts_) {
        const bool beside = characters(name) <= widest;
        if (!beside)
            result += "  " + name + '\n';
        result += hanging("  " + padded(beside ? name : "", width, Align::left) + "  ", value);
    }
    return result;
}

std::string with_sign(double value, int decimals) {
    std::string text = fmt::format("{:+.{}f}", value, decimals);
    if (text.find_first_not_of("-0.") == text.npos)
        text.front() = '+';
    return text;
}

std::string bar(double share, std::size_t width) {
    const double full = std::clamp(share, 0.0, 1.0) * static_cast<double>(width);
    return std::string(static_cast<std::size_t>(std::lround(full)), '#');
}

std::vector<std::string> texts_of(const std::vector<stltsa::Warning>& warnings) {
    std::vector<std::string> texts;
    for (const stltsa::Warning& warning : warnings)
        texts.emplace_back(warning.text);
    return texts;
}

std::string listed(const std::string& name, const std::vector<std::string>& texts) {
    std::string result;
    for (const std::string& text : texts)
        result += hanging("  " + name + "  ", with_flags(text));
    return result.empty() ? result : '\n' + result;
}

} // namespace tool
