// SPDX-License-Identifier: BSD-3-Clause
// Patches: their frame ranges, rank and blocks.
#include <algorithm>
#include <set>

#include "ltsa/alignment/column_blocks.hpp"
#include "ltsa/alignment/patch_passes.hpp"
#include "ltsa/testing.hpp"

namespace {

using namespace ltsa_testing;
using namespace stltsa::ltsa;

/// Each frame, the previous one, and any others at most `size` frames away.
Neighborhoods scattered(std::int64_t frames, std::int64_t size = 9) {
    Neighborhoods found{size, {}};
    stltsa::Random random(11);
    for (std::int64_t i = 0; i < frames; ++i) {
        const std::int64_t first = std::clamp(i - size, std::int64_t{0}, frames - 2 * size);
        std::set<std::int32_t> members{static_cast<std::int32_t>(i)};
        members.insert(static_cast<std::int32_t>(std::max<std::int64_t>(i - 1, 0)));
        while (static_cast<std::int64_t>(members.size()) < size)
            members.insert(static_cast<std::int32_t>(
                first +
                static_cast<std::int64_t>((1 + random.symmetric()) * static_cast<double>(size))));
        found.index.insert(found.index.end(), members.begin(), members.end());
    }
    return found;
}

struct Fixture {
    explicit Fixture(Neighborhoods from) : found(std::move(from)) {
        tangents.size = found.size;
        tangents.count = 2;
        tangents.rank.assign(static_cast<std::size_t>(found.frames()), 2);
        components = connected_components(found, {});
        assert_int_equal(components.count, 1);
    }
    Patches patches() const { return {found, tangents, components, 0, 2, machine}; }

    stltsa::Machine machine{stltsa::widest_simd(), 3};
    Neighborhoods found;
    Tangents tangents{};
    Components components;
};

/// Enough frames for several threads, with a smaller last group.
constexpr std::int64_t many = 50 * stltsa::row_block + 7;

void group_ranges_are_those_of_their_patches(void**) {
    const Fixture fixture(scattered(many));
    const Patches patches = fixture.patches();
    std::int64_t begin = 0;
    for (const Patches::FrameRange& group : patches.group_ranges()) {
        const std::int64_t end = std::min(begin + Patches::group_size, patches.count());
        std::int32_t first = patches.of(begin).front(), last = patches.of(begin).back();
        for (std::int64_t p = begin; p < end; ++p) {
            first = std::min(first, patches.of(p).front());
            last = std::max(last, patches.of(p).back());
        }
        assert_int_equal(group.first, first);
        assert_int_equal(group.last, last);
        begin = end;
    }
    assert_int_equal(begin, patches.count());
}

void rank_deficient_patches_are_counted(void**) {
    Fixture fixture(scattered(many));
    for (std::size_t i = 0; i < fixture.tangents.rank.size(); i += 1000)
        fixture.tangents.rank[i] = 1;
    assert_int_equal(fixture.patches().rank_deficient(), (many + 999) / 1000);
}

void every_column_has_the_patches_that_touch_it(void**) {
    const Fixture fixture(scattered(3000));
    const Patches patches = fixture.patches();
    for (const std::int64_t block : {100, 512, 5000}) {
        const std::int64_t order = patches.frames() - 1;
        const auto ranges = patches_by_block(patches, block, (order + block - 1) / block);
        for (std::int64_t p = 0; p < patches.count(); ++p)
            for (std::int64_t c = patches.of(p).front(); c < patches.of(p).back(); ++c) {
                const auto range = ranges[static_cast<std::size_t>(c / block)];
                assert_true(range.begin <= p && p < range.end);
            }
    }
}

/// Whether no two blocks of one parity share a frame.
bool blocks_are_apart(const Patches& patches, const PatchBlocks& blocks) {
    std::vector<std::int64_t> block_of[2];
    for (auto& of_frame : block_of)
        of_frame.assign(static_cast<std::size_t>(patches.frames()), -1);
    for (std::int64_t b = 0; b < blocks.count(); ++b)
        for (std::int64_t p = blocks.begin(b); p < blocks.end(b); ++p)
            for (const std::int32_t frame : patches.of(p)) {
                auto& block = block_of[b % 2][static_cast<std::size_t>(frame)];
                if (block != -1 && block != b)
                    return false;
                block = b;
            }
    return true;
}

/// Replaces the `j`-th frame of a patch, and expects a single block.
void check_one_block(Neighborhoods found, std::int64_t patch, std::int64_t j, std::int64_t frame) {
    found.index[static_cast<std::size_t>(patch * found.size + j)] =
        static_cast<std::int32_t>(frame);
    const Fixture linked(std::move(found));
    assert_int_equal(PatchBlocks(linked.patches()).count(), 1);
}

/// Small neighborhoods, and neighborhoods that need blocks larger than the minimum.
void blocks_of_one_parity_share_no_frame(void**) {
    for (const std::int64_t size : {9, 141}) {
        const Fixture near(scattered(5000, size));
        const Patches patches = near.patches();
        const PatchBlocks blocks(patches);
        const std::int64_t block = blocks.end(0);
        assert_true(block >= 4 * size);
        assert_true(blocks.count() > 4);
        assert_int_equal(blocks.end(blocks.count() - 1), patches.count());
        assert_true(blocks_are_apart(patches, blocks));

        // A frame shared by two blocks of one parity, at several places of a group and of a block.
        for (const std::int64_t p : {2 * block, 2 * block + 76, 3 * block - 1, 4 * block - 1})
            check_one_block(near.found, p, 0, p - 2 * block);
        for (const std::int64_t p : {std::int64_t{0}, std::int64_t{77}, block - 1, 2 * block - 1})
            check_one_block(near.found, p, size - 1, p + 2 * block);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(group_ranges_are_those_of_their_patches),
        cmocka_unit_test(rank_deficient_patches_are_counted),
        cmocka_unit_test(every_column_has_the_patches_that_touch_it),
        cmocka_unit_test(blocks_of_one_parity_share_no_frame),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
