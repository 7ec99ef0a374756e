// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/difference_terms.hpp"

#include <algorithm>
#include <numeric>

#include <cblas.h>

#include "base/parallel.hpp"
#include "linalg/simd.hpp"

namespace stltsa::ltsa {

namespace {

/// The sum of value(j) over the neighbors beyond each difference.
template <class Value>
void spread_sums(std::span<const std::int32_t> frames, const Value& value, double* to) {
    double sum = 0;
    for (std::size_t j = frames.size(); j-- > 1;) {
        sum += value(j);
        for (auto c = frames[j]; c-- > frames[j - 1];)
            to[c - frames.front()] = sum;
    }
}

/// Writes a at the differences that a patch covers.
void spread_counts(const Patches& patches, std::int64_t patch, double* to) {
    spread_sums(
        patches.of(patch), [](std::size_t) { return 1.0; }, to);
}

/// Writes h_0, h_1, ..., each `stride` entries after the one before.
void spread_directions(const Patches& patches, std::int64_t patch, double* to,
                       std::int64_t stride) {
    for (std::int64_t l = 0; l < patches.dimension(); ++l) {
        const double* g = patches.direction(patch, l);
        spread_sums(
            patches.of(patch), [g](std::size_t j) { return g[j]; }, to + l * stride);
    }
}

} // namespace

void PatchTerms::set(const Patches& patches, std::int64_t patch) {
    const auto frames = patches.of(patch);
    size_ = static_cast<double>(patches.size());
    first_ = frames.front();
    span_ = frames.back() - frames.front();
    values_.resize(static_cast<std::size_t>(span_ * (1 + patches.dimension())));
    spread_counts(patches, patch, values_.data());
    spread_directions(patches, patch, values_.data() + span_, span_);
}

std::vector<std::int64_t> envelope_of(const Patches& patches) {
    std::vector<std::int64_t> reach(static_cast<std::size_t>(patches.frames() - 1));
    std::iota(reach.begin(), reach.end(), 0);
    for (std::int64_t p = 0; p < patches.count(); ++p) {
        const auto frames = patches.of(p);
        if (frames.front() == frames.back())
            continue;
        std::int64_t& column = reach[static_cast<std::size_t>(frames.front())];
        column = std::max<std::int64_t>(column, frames.back() - 1);
    }
    for (std::size_t c = 1; c < reach.size(); ++c)
        reach[c] = std::max(reach[c], reach[c - 1]);
    return reach;
}

namespace {

/// Columns that one thread assembles at a time; patches at their borders are spread twice, and
/// those of wide bands take long and are many.
constexpr std::int64_t narrow_block = 512;
constexpr std::int64_t wide_block = 2048;

/// For each block of columns the range of patches that may touch it: patches are in order of their
/// center frame, not of their first, so the range is a hull.
struct PatchRange {
    std::int64_t begin, end;
};

std::vector<PatchRange> patches_by_block(const Patches& patches, std::int64_t column_block,
                                         std::int64_t blocks) {
    std::vector<PatchRange> ranges(static_cast<std::size_t>(blocks), {patches.count(), 0});
    for (std::int64_t p = 0; p < patches.count(); ++p) {
        const auto frames = patches.of(p);
        const std::int64_t last = std::max(frames.front(), frames.back() - 1) / column_block;
        for (std::int64_t b = frames.front() / column_block; b <= std::min(last, blocks - 1); ++b) {
            auto& range = ranges[static_cast<std::size_t>(b)];
            range.begin = std::min(range.begin, p);
            range.end = std::max(range.end, p + 1);
        }
    }
    return ranges;
}

/// Calls work(begin, end, patches) for all columns [begin, end) and the patches that may touch
/// them.
template <class Work>
void for_column_blocks(const Patches& patches, std::int64_t order, std::int64_t column_block,
                       int threads, const Work& work) {
    const std::int64_t blocks = (order + column_block - 1) / column_block;
    const auto ranges = patches_by_block(patches, column_block, blocks);
    parallel_blocks(blocks, threads, [&](std::int64_t b) {
        const std::int64_t begin = b * column_block;
        work(begin, std::min(begin + column_block, order), ranges[static_cast<std::size_t>(b)]);
    });
}

/// Adds one patch's part of the columns [begin, end):
///     column[r] += a[r] before - sum_l h_l[0] h_l[r]
struct AddPatch {
    EnvelopeMatrix& matrix;
    std::int64_t begin, end;
    std::int64_t first, span;
    double size;
    const double* beyond;
    const double* sums; ///< of each dimension, `span` adjacent
    std::int64_t dimension;

    template <int W>
    STLTSA_INLINE void run() const {
        for (std::int64_t c = std::max(begin, first); c < std::min(end, first + span); ++c) {
            double* column = matrix.column(c);
            const std::int64_t from = c - first;
            const std::int64_t length = span - from;
            const double before = (size - beyond[from]) / size;
            std::int64_t r = 0;
            for (; r + W <= length; r += W)
                store(entry<Pack<W>>(column, before, from, r), column + r);
            for (; r < length; ++r)
                store(entry<double>(column, before, from, r), column + r);
        }
    }

    template <class P>
    STLTSA_INLINE P entry(const double* column, double before, std::int64_t from,
                          std::int64_t r) const {
        P value = load<P>(column + r) + load<P>(beyond + from + r) * before;
        for (std::int64_t l = 0; l < dimension; ++l) {
            const double* h = sums + l * span + from;
            value -= h[0] * load<P>(h + r);
        }
        return value;
    }
};

} // namespace

void assemble(const Patches& patches, const Machine& machine, EnvelopeMatrix& matrix) {
    for_column_blocks(patches, matrix.order(), narrow_block, machine.threads,
                      [&](std::int64_t begin, std::int64_t end, PatchRange range) {
                          matrix.clear(begin, end);
                          PatchTerms terms;
                          for (std::int64_t p = range.begin; p < range.end; ++p) {
                              const auto frames = patches.of(p);
                              if (frames.front() >= end || frames.back() <= begin)
                                  continue;
                              terms.set(patches, p);
                              run_simd(machine.simd,
                                       AddPatch{matrix, begin, end, terms.first(), terms.span(),
                                                terms.size(), terms.beyond(), terms.sums(),
                                                patches.dimension()});
                          }
                      });
}

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
        spread_counts(patches_, patch, beyond_.data());
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
            spread_directions(patches, p,
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

} // namespace

void assemble(const Patches& patches, const Machine& machine, BlockEnvelopeMatrix& matrix) {
    constexpr std::int64_t columns = BlockEnvelopeMatrix::block_columns;
    static_assert(wide_block % columns == 0);
    for_column_blocks(
        patches, matrix.order(), wide_block, machine.threads,
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
