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

std::string Table::text() const {
    std::vector<std::size_t> widths(columns_.size(), 0);
    for (const auto& row : rows_)
        for (std::size_t c = 0; c < row.size(); ++c)
            widths[c] = std::max(widths[c], characters(row[c]));
    std::string result;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        std::string line;
        for (std::size_t c = 0; c < rows_[r].size(); ++c)
            line += "  " + padded(rows_[r][c], widths[c], columns_[c]);
        line = without_trailing_blanks(line);
        result += (r < heading_rows_ ? dim(line) : line) + '\n';
    }
    return result;
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

std::string bar(double share, std::size_t width) {
    const double full = std::clamp(share, 0.0, 1.0) * static_cast<double>(width);
    return std::string(static_cast<std::size_t>(std::lround(full)), '#');
}

std::string listed(const std::string& name, const std::vector<std::string>& texts) {
    std::string result;
    for (const std::string& text : texts)
        result += hanging("  " + name + "  ", with_flags(text));
    return result.empty() ? result : '\n' + result;
}

} // namespace tool
