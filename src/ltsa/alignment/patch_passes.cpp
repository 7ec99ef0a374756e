// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/alignment/patch_passes.hpp"

#include <span>

namespace stltsa::ltsa {

void Alignment::solve(MatrixView unknowns, std::int64_t count) const {
    if (unknowns.cols == 1) {
        solve_rows({unknowns.data, 1, unknowns.rows, unknowns.rows});
        return;
    }
    Matrix rows = rows_of(unknowns, count, machine_);
    solve_rows(rows.view());
    set_columns(rows, unknowns, machine_);
}

namespace {

/// Patches of a block: a multiple of the group size.
std::int64_t block_size(const Patches& patches) {
    constexpr std::int64_t group = Patches::group_size;
    return group * std::max<std::int64_t>(8, (4 * patches.size() + group - 1) / group);
}

/// Whether, by the frame ranges of the groups, no two blocks of one parity share a frame.
bool are_apart(std::span<const Patches::FrameRange> ranges, std::size_t groups_in_block) {
    std::int32_t before[2] = {-1, -1}; // last frame of the earlier blocks of each parity
    std::int32_t last = -1;
    for (std::size_t g = 0; g < ranges.size(); ++g) {
        const std::size_t parity = g / groups_in_block % 2;
        if (ranges[g].first <= before[parity])
            return false;
        last = std::max(last, ranges[g].last);
        if ((g + 1) % groups_in_block == 0)
            before[parity] = last;
    }
    return true;
}

} // namespace

PatchBlocks::PatchBlocks(const Patches& patches)
    : patches_(patches.count()), size_(block_size(patches)),
      count_((patches.count() + size_ - 1) / size_) {
    if (!are_apart(patches.group_ranges(), static_cast<std::size_t>(size_ / Patches::group_size))) {
        size_ = patches_;
        count_ = 1;
    }
}

} // namespace stltsa::ltsa
