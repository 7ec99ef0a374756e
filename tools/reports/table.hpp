// SPDX-License-Identifier: BSD-3-Clause
// Text for people: aligned columns, in plain ASCII except for the user's file names.
#pragma once

#include <string>
#include <vector>

#include <stltsa.hpp>

namespace tool {

enum class Align { left, right };

class Table {
  public:
    explicit Table(std::vector<Align> columns, std::size_t heading_rows = 1)
        : columns_(std::move(columns)), heading_rows_(heading_rows) {}
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    /// One indented line per row; the first rows are the heading. If a row does not fit into the
    /// terminal, its last cell, a remark, goes to lines of its own.
    std::string text() const;

    /// Of more than three rows in a run that differ only in their first cells, the first and the
    /// last are shown, with the number of the others between them.
    void fold(std::size_t first_cells);

  private:
    std::string line_of(const std::vector<std::string>& row,
                        const std::vector<std::size_t>& widths) const;

    std::vector<Align> columns_;
    std::size_t heading_rows_;
    std::vector<std::vector<std::string>> rows_;
};

/// Lines of "name  value": names in one column, long values wrapped.
class Facts {
  public:
    void add(std::string name, std::string value);
    std::string text() const;

  private:
    std::vector<std::pair<std::string, std::string>> facts_;
};

/// A number with its sign and so many decimals; "+" if all digits are zero.
std::string with_sign(double value, int decimals);

/// A bar of `width` characters for a share of 1, fewer for less.
std::string bar(double share, std::size_t width);

/// One line "name  text" per text; empty without texts.
std::string listed(const std::string& name, const std::vector<std::string>& texts);

std::vector<std::string> texts_of(const std::vector<stltsa::Warning>& warnings);

} // namespace tool
