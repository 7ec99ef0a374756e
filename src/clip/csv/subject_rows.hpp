// SPDX-License-Identifier: BSD-3-Clause
// Tables with a row for each frame of each subject, as SLEAP writes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Whether a column, or a line of a header, has subjects: "track", "individual", "subject", ...
bool names_subject(std::string_view label);

/// Keeps the rows of one subject, and their lines, by the text of the column for each row, if the
/// column has names or if rows repeat a frame number. Throws if several rows of the subject are of
/// one frame, and as one_subject.
void take_rows_of_subject(Clip& clip, std::optional<std::size_t> column,
                          const std::vector<std::string>& subjects,
                          std::vector<std::int64_t>& lines, const std::string& file,
                          const ReadOptions& options);

} // namespace stltsa::clip
