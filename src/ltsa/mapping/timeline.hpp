// SPDX-License-Identifier: BSD-3-Clause
// The rows of a model in order of time, without those that repeat the previous row.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/search/nearest_rows.hpp"

namespace stltsa::ltsa {

class Timeline {
  public:
    Timeline() = default;
    /// `lengths`: rows of each clip, summing to the rows.
    Timeline(ConstMatrixView frames, std::span<const std::int64_t> lengths);

    /// Rows that differ from the previous row or begin a clip; ascending.
    const std::vector<std::int32_t>& distinct() const { return distinct_; }
    /// The row itself, or the row that it repeats.
    std::int64_t original(std::int64_t row) const { return distinct_[position(row)]; }
    /// The next original row of the same clip; -1 at its end.
    std::int64_t next(std::int64_t row) const;
    /// The rows within `reach` originals on each side, in the same clip.
    RowRange around(std::int64_t row, std::int64_t reach) const;

  private:
    std::size_t position(std::int64_t row) const {
        return static_cast<std::size_t>(position_[static_cast<std::size_t>(row)]);
    }
    std::int32_t clip(std::int64_t row) const { return clip_[position(row)]; }

    std::vector<std::int32_t> distinct_;
    std::vector<std::int32_t> clip_;     ///< of each distinct row
    std::vector<std::int32_t> position_; ///< index of each row in distinct_
    std::vector<std::int32_t> begin_;    ///< index of each clip in distinct_, and its size
};

} // namespace stltsa::ltsa
