// SPDX-License-Identifier: BSD-3-Clause
// Several lines before the numbers: the preambles of motion capture systems, and headers of several
// levels as pandas and DeepLabCut write them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clip/features/subject_names.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {

struct Head {
    /// One per column; levels joined by _, as in "heel_x", with a unit that is not one of length.
    std::vector<std::string> names;
    char separator = ',';
    double fps = 0; ///< 0: the lines do not say
    std::vector<std::string> notes;
    std::vector<Subject> subjects; ///< of a line of individuals, once each
};

/// Reads such lines, and leaves the cursor before the first row of numbers. Empty, and the cursor
/// is not moved, if there is one header line at most, or if the lines cannot be understood.
std::optional<Head> read_head(TextCursor& in);

} // namespace stltsa::clip
