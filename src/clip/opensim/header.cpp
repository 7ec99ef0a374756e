// SPDX-License-Identifier: BSD-3-Clause
#include "clip/opensim/header.hpp"

#include <algorithm>
#include <iterator>

#include "clip/csv/cells.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {

std::vector<std::string> header_cells(std::string_view line) {
    const char separator = line.find('\t') != line.npos  ? '\t'
                           : line.find(';') != line.npos ? ';'
                           : line.find(',') != line.npos ? ','
                                                         : ' ';
    std::vector<std::string> cells;
    if (const auto parts = split_cells(line, separator))
        std::ranges::transform(*parts, std::back_inserter(cells), text_of);
    while (!cells.empty() && cells.back().empty())
        cells.pop_back();
    return cells;
}

bool ends_header(std::string_view line) {
    return equals_ignoring_case(next_word(line, ",;"), "endheader");
}

void note_other_count(Clip& clip, std::string_view key, std::string_view said, std::int64_t found) {
    if (const auto count = parse_integer(said); count && *count != found)
        clip.notes.push_back(
            format_text("the header says {} {}, but the file has {}", key, *count, found));
}

} // namespace stltsa::clip
