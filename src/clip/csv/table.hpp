// SPDX-License-Identifier: BSD-3-Clause
// Rows of numbers, which all text formats have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features/subject_names.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {

/// What is known of the cells besides their numbers.
struct TableFacts {
    std::vector<std::int64_t> lines; ///< of each row, in the file
    std::vector<std::int64_t> dated; ///< columns of dates, in seconds; ascending
    std::vector<Subject> subjects;   ///< that the header states
};

/// The names of columns, which the lines before a table say.
struct TableHead {
    std::vector<std::string> names;
    bool may_end_early = false; ///< rows without the last cells, which are then missing
};

/// Reads the rows from here to the end, and sets the values and names of the channels.
TableFacts read_rows(TextCursor& in, Clip& clip, TableHead head, const ReadOptions& options);

} // namespace stltsa::clip
