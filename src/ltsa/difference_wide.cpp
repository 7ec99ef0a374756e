// SPDX-License-Identifier: BSD-3-Clause
// B' of a wide band: the counts follow from column to column, the directions are matrix products.
#include <algorithm>
#include <span>
#include <vector>

#include <cblas.h>

#include "linalg/simd.hpp"
#include "ltsa/column_blocks.hpp"
#include "ltsa/difference_terms.hpp"

namespace stltsa::ltsa {

namespace {

/// Makes a column of its sums the next one, from what its steps have more of.
struct SumColumn {
    double *steps, *sums, *column;
    std::int64_t count;
    double size;

    template <int W>
    STLTSA_INLINE void run() const {
        std::int64_t r = 0;
        for (; r + W <= count; r += W)
            next<Pack<W>>(r);
        for (; r < count; ++r)
            next<double>(r);
    }

    template <class P>
    STLTSA_INLINE void next(std::int64_t r) const {
        const P step = load<P>(steps + r) + load<P>(column + r);
        const P sum = load<P>(sums + r) + step;
        store(step, steps + r);
        store(sum, sums + r);
        store(sum / size, column + r);
    }
};

/// The columns of some blocks, which follow each other.
using Blocks = std::span<const BlockEnvelopeMatrix::Block>;

/// The part of B' that counts frames: the sum of a(c') (k - a(c)) over patches grows, from one
/// column to the next, by the a(c') of the patches that have frame c. These change only where a run
/// of frames begins or ends in a patch. All are whole numbers, exact in any order, until they are
/// divided by k.
class Counts {
  public:
    Counts(const Patches& patches, BlockEnvelopeMatrix& matrix, Blocks blocks)
        : patches_(patches), matrix_(matrix), blocks_(blocks), begin_(blocks.front().begin),
          end_(blocks.back().begin + blocks.back().columns),
          sums_(static_cast<std::size_t>(last_row(blocks.back()) + 1 - begin_)), steps_(sums_) {}

    /// Leaves in the columns what each has more of than the one before.
    void add(std::int64_t patch) {
        const auto frames = patches_.of(patch);
        beyond_.resize(static_cast<std::size_t>(frames.back() - frames.front()));
        spread_counts(patches_, patch, Order::of_time, beyond_.data());
        if (frames.front() <= begin_ && begin_ < frames.back())
            start(frames);
        for (std::size_t j = 0; j < frames.size(); ++j) {
            if (j == 0 || frames[j - 1] + 1 < frames[j])
                change(frames, frames[j], 1);
            if (j + 1 < frames.size() && frames[j] + 1 < frames[j + 1])
                change(frames, frames[j] + 1, -1);
        }
    }

    /// After all patches: the columns become sums, over k.
    void finish(Simd simd) {
        for (const auto& block : blocks_)
            for (std::int64_t c = block.begin; c < block.begin + block.columns; ++c)
                run_simd(simd, SumColumn{steps_.data() + (c - begin_), sums_.data() + (c - begin_),
                                         diagonal(block, c), last_row(block) + 1 - c,
                                         static_cast<double>(patches_.size())});
    }

  private:
    static std::int64_t last_row(const BlockEnvelopeMatrix::Block& block) {
        return block.begin + block.rows - 1;
    }
    double* diagonal(const BlockEnvelopeMatrix::Block& block, std::int64_t column) {
        return matrix_.data(block) + (column - block.begin) * (block.rows + 1);
    }

    /// What the column before the first leaves, and what the first has more.
    void start(std::span<const std::int32_t> frames) {
        const double* beyond = beyond_.data() + (begin_ - frames.front());
        const std::int64_t length = frames.back() - begin_;
        const double more = std::ranges::binary_search(frames, begin_) ? 1 : 0;
        axpy(static_cast<double>(patches_.size()) - beyond[0] - more, beyond, sums_.data(), length);
        axpy(more, beyond, steps_.data(), length);
    }

    /// From `column` on the patch has, or has not, its frame.
    void change(std::span<const std::int32_t> frames, std::int64_t column, double sign) {
        if (column <= begin_ || column >= end_)
            return;
        const auto& block = blocks_[static_cast<std::size_t>((column - begin_) /
                                                             BlockEnvelopeMatrix::block_columns)];
        axpy(sign, beyond_.data() + (column - frames.front()), diagonal(block, column),
             frames.back() - column);
    }

    const Patches& patches_;
    BlockEnvelopeMatrix& matrix_;
    Blocks blocks_;
    std::int64_t begin_, end_;
    std::vector<double> sums_;  ///< of a(c') (k - a(c)), in the column at hand
    std::vector<double> steps_; ///< of a(c') where there is frame c
    std::vector<double> beyond_;
};

/// Some patches whose directions are one matrix product: for the differences [first, last) that
/// they cover,
///     B'(c', c) -= sum_r h(c', r) h(c, r),     c' >= c
/// with zeros where a patch does not reach.
class Tile {
  public:
    void set(const Patches& patches, std::int64_t begin, std::int64_t end) {
        first_ = patches.frames();
        last_ = 0;
        for (std::int64_t p = begin; p < end; ++p) {
            first_ = std::min<std::int64_t>(first_, patches.of(p).front());
            last_ = std::max<std::int64_t>(last_, patches.of(p).back());
        }
        const std::int64_t length = last_ - first_;
        rank_ = (end - begin) * patches.dimension();
        sums_.assign(checked_size(std::max<std::int64_t>(length, 0), rank_), 0);
        for (std::int64_t p = begin; p < end; ++p)
            spread_directions(patches, p, Order::of_time,
                              sums_.data() + (p - begin) * patches.dimension() * length +
                                  (patches.of(p).front() - first_),
                              length);
    }

    /// To the columns of one block that the tile covers.
    void add_to(BlockEnvelopeMatrix& matrix, const BlockEnvelopeMatrix::Block& block) const {
        const std::int64_t begin = std::max(block.begin, first_);
        const std::int64_t columns = std::min(block.begin + block.columns, last_) - begin;
        const std::int64_t rows = std::min(block.begin + block.rows, last_) - begin;
        if (columns <= 0)
            return;
        const auto ld = static_cast<int>(last_ - first_);
        const double* sums = sums_.data() + (begin - first_);
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, static_cast<int>(rows),
                    static_cast<int>(columns), static_cast<int>(rank_), -1, sums, ld, sums, ld, 1,
                    matrix.data(block) + (begin - block.begin) * (block.rows + 1),
                    static_cast<int>(block.rows));
    }

  private:
    std::int64_t first_ = 0, last_ = 0, rank_ = 0;
    AlignedVector<double> sums_;
};

/// Patches of one tile: the more, the better the product; but the differences that only some of
/// them cover are padded with zeros.
constexpr std::int64_t tile_patches = 24;

/// Columns that one thread assembles at a time; patches at their borders are spread twice, and they
/// take long and are many.
constexpr std::int64_t column_block = 2048;
static_assert(column_block % BlockEnvelopeMatrix::block_columns == 0);

} // namespace

void assemble(const Patches& patches, const Machine& machine, BlockEnvelopeMatrix& matrix) {
    constexpr std::int64_t columns = BlockEnvelopeMatrix::block_columns;
    for_column_blocks(
        patches, matrix.order(), column_block, machine.threads,
        [&](std::int64_t begin, std::int64_t end, PatchRange range) {
            const Blocks blocks =
                std::span(matrix.blocks())
                    .subspan(static_cast<std::size_t>(begin / columns),
                             static_cast<std::size_t>((end - begin + columns - 1) / columns));
            for (const auto& block : blocks)
                matrix.clear(block);
            Counts counts(patches, matrix, blocks);
            for (std::int64_t p = range.begin; p < range.end; ++p)
                counts.add(p);
            counts.finish(machine.simd);
            Tile tile;
            // Tiles have the same borders for every block.
            for (std::int64_t p = range.begin / tile_patches * tile_patches; p < range.end;
                 p += tile_patches) {
                tile.set(patches, p, std::min(p + tile_patches, patches.count()));
                for (const auto& block : blocks)
                    tile.add_to(matrix, block);
            }
        });
}

} // namespace stltsa::ltsa
