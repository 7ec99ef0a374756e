// SPDX-License-Identifier: BSD-3-Clause
// Text for people: columns that line up, in plain ASCII but for the names that the user chose.
#pragma once

#include <string>
#include <vector>

namespace tool {

enum class Align { left, right };

class Table {
  public:
    explicit Table(std::vector<Align> columns) : columns_(std::move(columns)) {}
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    /// A line per row, indented; the first row is the heading.
    std::string text() const;

  private:
    std::vector<Align> columns_;
    std::vector<std::vector<std::string>> rows_;
};

/// Lines of "name  value", names in one column, long values wrapped.
class Facts {
  public:
    void add(std::string name, std::string value);
    std::string text() const;

  private:
    std::vector<std::pair<std::string, std::string>> facts_;
};

/// A bar of at most `width` characters for a share of 1.
std::string bar(double share, std::size_t width);

/// Lines "name: text" for each text; nothing for none.
std::string listed(const std::string& name, const std::vector<std::string>& texts);

} // namespace tool
