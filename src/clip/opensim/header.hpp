// SPDX-License-Identifier: BSD-3-Clause
// What the headers of TRC, MOT and STO files have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// The cells of a line of a header, which may be separated by tabs, commas, semicolons or blanks.
/// Empty ones at the end are left out.
std::vector<std::string> header_cells(std::string_view line);

/// Whether the line, perhaps with empty cells after it, ends the header of a MOT or STO file.
bool ends_header(std::string_view line);

/// Notes that the header counts other rows or columns than there are. `said`: a number; other texts
/// are not compared.
void note_other_count(Clip& clip, std::string_view key, std::string_view said, std::int64_t found);

} // namespace stltsa::clip
