// SPDX-License-Identifier: BSD-3-Clause
// Blocks of columns of B' for threads, each with the patches that contribute to it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "ltsa/alignment/patches.hpp"

namespace stltsa::ltsa {

/// A range of patches that includes all that touch a block of columns, and maybe others: patches
/// are ordered by their center frame, not by their first.
struct PatchRange {
    std::int64_t begin, end;
};

inline std::vector<PatchRange> patches_by_block(const Patches& patches, std::int64_t column_block,
                                                std::int64_t blocks) {
    std::vector<PatchRange> ranges(static_cast<std::size_t>(blocks), {patches.count(), 0});
    std::int64_t begin = 0;
    for (const Patches::FrameRange& frames : patches.group_ranges()) {
        const std::int64_t end = std::min(begin + Patches::group_size, patches.count());
        const std::int64_t last = std::max(frames.first, frames.last - 1) / column_block;
        for (std::int64_t b = frames.first / column_block; b <= std::min(last, blocks - 1); ++b) {
            auto& range = ranges[static_cast<std::size_t>(b)];
            range.begin = std::min(range.begin, begin);
            range.end = std::max(range.end, end);
        }
        begin = end;
    }
    return ranges;
}

/// Calls work(begin, end, patches) for each block of columns [begin, end).
template <class Work>
void for_column_blocks(const Patches& patches, std::int64_t order, std::int64_t column_block,
                       int threads, const Work& work) {
    const std::int64_t blocks = (order + column_block - 1) / column_block;
    const auto ranges = patches_by_block(patches, column_block, blocks);
    parallel_blocks(
        blocks, threads,
        [&](std::int64_t b) {
            const std::int64_t begin = b * column_block;
            work(begin, std::min(begin + column_block, order), ranges[static_cast<std::size_t>(b)]);
        },
        Stage::alignment);
}

} // namespace stltsa::ltsa
