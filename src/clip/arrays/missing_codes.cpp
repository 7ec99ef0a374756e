// SPDX-License-Identifier: BSD-3-Clause
#include "clip/arrays/missing_codes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/checkpoint.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

constexpr std::int64_t least_cells = 3;
/// One column of nothing else may be a constant; those of a point that is never there are several.
constexpr std::int64_t least_alone = 2;

/// Whether the number may be a code: its digits are nines, perhaps zeros after them if a unit was
/// changed; a power of ten from a million; or the largest number of single or double precision.
bool may_be_code(double number) {
    constexpr double shortest = 999, longest = 1e16, million = 1e6, hundredths = 100;
    // Six digits are what many programs print.
    constexpr double largest = std::numeric_limits<float>::max(), rounded = 3e-6;
    const double size = std::abs(number), whole = std::round(hundredths * size);
    if (std::abs(size - largest) <= rounded * largest || size == std::numeric_limits<double>::max())
        return true;
    if (!(size >= shortest && size < longest) || std::abs(whole / hundredths - size) > 0)
        return false;
    auto digits = static_cast<std::int64_t>(whole);
    while (digits % 10 == 0)
        digits /= 10;
    const bool are_enough = digits >= static_cast<std::int64_t>(shortest);
    const bool is_power = digits == 1 && size >= million;
    while (digits % 10 == 9)
        digits /= 10;
    return is_power || (are_enough && digits == 0);
}

struct NumberColumn {
    double least = std::numeric_limits<double>::infinity(), most = -least; ///< of the others
    std::map<double, std::int64_t> codes;                                  ///< cells of each

    bool is_outside(double code) const { return code < least || code > most; }
    bool is_alone() const { return least > most && codes.size() == 1; }
    /// Equal numbers tell no distance.
    bool is_far(double code) const {
        return least < most && std::max(least - code, code - most) > most - least;
    }
};

std::vector<NumberColumn> columns_in(const Matrix& values) {
    std::vector<NumberColumn> columns(static_cast<std::size_t>(values.cols()));
    for (std::int64_t i = 0; i < values.rows(); ++i, checkpoint(values.cols()))
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const double number = values.row(i)[c];
            if (may_be_code(number)) {
                ++columns[c].codes[number];
            } else if (!std::isnan(number)) {
                columns[c].least = std::min(columns[c].least, number);
                columns[c].most = std::max(columns[c].most, number);
            }
        }
    return columns;
}

/// The cells of a code, by their columns.
using CodeCells = std::map<std::size_t, std::int64_t>;

/// What is outside in enough cells, and far outside in one column, or alone in several.
std::map<double, CodeCells> codes_of(const std::vector<NumberColumn>& columns) {
    struct Seen {
        std::int64_t cells = 0, alone = 0;
        bool is_far = false;
    };
    std::map<double, Seen> all;
    for (const NumberColumn& column : columns)
        for (const auto& [code, count] : column.codes) {
            Seen& seen = all[code];
            seen.cells += column.is_outside(code) ? count : 0;
            seen.alone += column.is_alone() ? 1 : 0;
            seen.is_far = seen.is_far || column.is_far(code);
        }
    std::map<double, CodeCells> codes;
    for (const auto& [code, seen] : all)
        if (seen.cells >= least_cells && (seen.is_far || seen.alone >= least_alone))
            codes[code];
    return codes;
}

std::string note_of(double code, const CodeCells& cells, const std::vector<std::string>& names) {
    std::int64_t count = 0;
    std::vector<std::string> named;
    for (const auto& [column, times] : cells) {
        count += times;
        if (!names.empty())
            named.push_back(names[column]);
    }
    return format_text(
        "{:.15g} is far outside the other numbers, as where a value is missing: taken "
        "as missing, {} times in {} column{}{}",
        code, count, cells.size(), cells.size() == 1 ? "" : "s",
        named.empty() ? "" : ": " + list_in_quotes(named, 3));
}

} // namespace

void drop_missing_codes(Matrix& values, const std::vector<std::string>& names,
                        std::vector<std::string>& notes) {
    const std::vector<NumberColumn> columns = columns_in(values);
    std::map<double, CodeCells> codes = codes_of(columns);
    if (codes.empty())
        return;
    for (std::int64_t i = 0; i < values.rows(); ++i, checkpoint(values.cols()))
        for (std::size_t c = 0; c < columns.size(); ++c) {
            double& number = values.row(i)[c];
            const auto code = may_be_code(number) ? codes.find(number) : codes.end();
            if (code == codes.end() || !columns[c].is_outside(number))
                continue;
            ++code->second[c];
            number = std::numeric_limits<double>::quiet_NaN();
        }
    for (const auto& [code, cells] : codes)
        notes.push_back(note_of(code, cells, names));
}

} // namespace stltsa::clip
