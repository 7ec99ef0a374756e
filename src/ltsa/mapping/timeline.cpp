// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/mapping/timeline.hpp"

#include <algorithm>

namespace stltsa::ltsa {

Timeline::Timeline(ConstMatrixView frames, std::span<const std::int64_t> lengths) {
    position_.reserve(static_cast<std::size_t>(frames.rows));
    const auto size = [this] { return static_cast<std::int32_t>(distinct_.size()); };
    std::int64_t first = 0;
    for (std::size_t clip = 0; clip < lengths.size(); ++clip) {
        begin_.push_back(size());
        for (std::int64_t row = first; row < first + lengths[clip]; ++row) {
            if (row == first ||
                !std::equal(frames.row(row), frames.row(row) + frames.cols, frames.row(row - 1))) {
                distinct_.push_back(static_cast<std::int32_t>(row));
                clip_.push_back(static_cast<std::int32_t>(clip));
            }
            position_.push_back(size() - 1);
        }
        first += lengths[clip];
    }
    begin_.push_back(size());
}

std::int64_t Timeline::next(std::int64_t row) const {
    const std::size_t after = position(row) + 1;
    return after < distinct_.size() && clip_[after] == clip(row) ? distinct_[after] : -1;
}

RowRange Timeline::around(std::int64_t row, std::int64_t reach) const {
    const auto here = static_cast<std::int64_t>(position(row));
    const auto clip_index = static_cast<std::size_t>(clip(row));
    const std::int64_t first = begin_[clip_index];
    const std::int64_t last = begin_[clip_index + 1] - 1;
    const std::int64_t begin = here - std::min(reach, here - first);
    const std::int64_t end = here + std::min(reach, last - here);
    return {distinct_[static_cast<std::size_t>(begin)],
            distinct_[static_cast<std::size_t>(end)] + std::int64_t{1}};
}

} // namespace stltsa::ltsa
