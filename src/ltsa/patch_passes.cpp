// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/patch_passes.hpp"

namespace stltsa::ltsa {

PatchBlocks::PatchBlocks(const Patches& patches)
    : patches_(patches.count()), size_(std::max<std::int64_t>(512, 4 * patches.size())),
      count_((patches.count() + size_ - 1) / size_) {
    std::int64_t reached[2] = {0, 0}; // by the blocks of each parity so far
    for (std::int64_t b = 0; b < count_; ++b) {
        std::int64_t first = patches.frames();
        std::int64_t last = -1;
        for (std::int64_t p = begin(b); p < end(b); ++p) {
            first = std::min<std::int64_t>(first, patches.of(p).front());
            last = std::max<std::int64_t>(last, patches.of(p).back());
        }
        if (first < reached[b % 2]) {
            size_ = patches_;
            count_ = 1;
            return;
        }
        reached[b % 2] = last + 1;
    }
}

} // namespace stltsa::ltsa
