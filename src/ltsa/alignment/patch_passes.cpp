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

/// A whole number of hulls.
std::int64_t block_size(const Patches& patches) {
    constexpr std::int64_t hull = Patches::hull_size;
    return hull * std::max<std::int64_t>(8, (4 * patches.size() + hull - 1) / hull);
}

/// Whether no two blocks of one parity can have a frame in common, as far as hulls tell.
bool are_apart(std::span<const Patches::Hull> hulls, std::size_t hulls_in_block) {
    std::int32_t before[2] = {-1, -1}; // last frame so far, at the end of a block of each parity
    std::int32_t last = -1;
    for (std::size_t h = 0; h < hulls.size(); ++h) {
        const std::size_t parity = h / hulls_in_block % 2;
        if (hulls[h].first <= before[parity])
            return false;
        last = std::max(last, hulls[h].last);
        if ((h + 1) % hulls_in_block == 0)
            before[parity] = last;
    }
    return true;
}

} // namespace

PatchBlocks::PatchBlocks(const Patches& patches)
    : patches_(patches.count()), size_(block_size(patches)),
      count_((patches.count() + size_ - 1) / size_) {
    if (!are_apart(patches.hulls(), static_cast<std::size_t>(size_ / Patches::hull_size))) {
        size_ = patches_;
        count_ = 1;
    }
}

} // namespace stltsa::ltsa
