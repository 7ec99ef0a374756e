// SPDX-License-Identifier: BSD-3-Clause
// Columns that count rows: frames, packets, samples.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace stltsa::clip {

/// Whether the values are whole numbers with exact differences.
bool are_whole(const std::vector<double>& values);

struct RowCount {
    std::vector<std::int64_t> places; ///< of the rows, from 0; a place without a row is a lost one
    std::int64_t step = 1;            ///< numbers between one place and the next
};

/// Whole numbers that increase, most of them by the same step and the others by multiples of it.
/// They may begin again at 0 after 255, 65535 or 4294967295, as counters of packets do. Empty if
/// the values are others.
std::optional<RowCount> row_count(std::vector<double> values);

/// Turns numbers of frames into numbers of rows if `subframes` counts the rows of each frame.
/// Returns whether it does.
bool add_subframes(std::vector<double>& frames, const std::vector<double>& subframes);

} // namespace stltsa::clip
