// SPDX-License-Identifier: BSD-3-Clause
// Alignment in differences. With x = S z (S the running sum), B' = S^T B S keeps the band of B, has
// no null vector, and its smallest eigenvalues are larger by about n^2. Every row of
// (I - e e^T/k - G G^T) sums to zero, so S^T B S can be written down patch by patch: for frames
// p_0 < ... < p_{k-1} and p_0 <= c <= c' < p_{k-1}, with a(c) the number of frames beyond c and
// h_l(c) the sum of g_l over them,
//     B'(c', c) += a(c') (k - a(c)) / k - sum_l h_l(c') h_l(c).
#include "ltsa/alignment.hpp"

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"
#include "linalg/envelope.hpp"
#include "ltsa/patch_passes.hpp"

namespace stltsa::ltsa {

namespace {

/// Pivots this small against their diagonal entry mean a flat direction: regular ones stay above
/// 5e-5 on motion and on smooth synthetic curves, flat ones are below 1e-16.
constexpr double smallest_pivot = 1e-13;

/// Frames in a flat space of d dimensions make B' singular: the embedding is its null space. A
/// shift of this share of the largest diagonal entry then stands in for the zero eigenvalues, the
/// same for all of them; inverse iteration through the patches removes what it does to the vectors.
constexpr double flat_shift = 1e-13;

/// Columns that one thread assembles at a time.
constexpr std::int64_t column_block = 512;

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

/// One patch spread over the differences it covers.
class PatchTerms {
  public:
    void set(const Patches& patches, std::int64_t patch) {
        const auto frames = patches.of(patch);
        const auto k = patches.size();
        dimension_ = patches.dimension();
        size_ = static_cast<double>(k);
        first_ = frames.front();
        span_ = frames.back() - frames.front();
        beyond_.resize(static_cast<std::size_t>(span_));
        sums_.resize(static_cast<std::size_t>(span_ * dimension_));
        // Differences between two neighbors have the same neighbors beyond them.
        for (std::int64_t l = 0; l < dimension_; ++l) {
            const double* g = patches.direction(patch, l);
            double h = 0;
            for (std::int64_t j = k - 1; j > 0; --j) {
                h += g[j];
                fill(frames, j, sums_.data() + l * span_, h);
            }
        }
        for (std::int64_t j = k - 1; j > 0; --j)
            fill(frames, j, beyond_.data(), static_cast<double>(k - j));
    }

    void add_to(EnvelopeMatrix& matrix, std::int64_t begin, std::int64_t end, Simd simd) const {
        run_simd(simd, AddPatch{matrix, begin, end, first_, span_, size_, beyond_.data(),
                                sums_.data(), dimension_});
    }

  private:
    /// For the differences between neighbors j-1 and j.
    void fill(std::span<const std::int32_t> frames, std::int64_t j, double* out,
              double value) const {
        const auto at = static_cast<std::size_t>(j);
        std::fill(out + (frames[at - 1] - first_), out + (frames[at] - first_), value);
    }

    std::int64_t first_ = 0;
    std::int64_t span_ = 0;
    std::int64_t dimension_ = 0;
    double size_ = 0;
    std::vector<double> beyond_;
    std::vector<double> sums_;
};

/// For each block of columns the range of patches that may touch it: patches are in order of their
/// center frame, not of their first, so the range is a hull.
struct PatchRange {
    std::int64_t begin, end;
};

std::vector<PatchRange> patches_by_block(const Patches& patches, std::int64_t blocks) {
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

/// Every column receives its patches in the same order whatever the number of threads.
void assemble(const Patches& patches, int threads, Simd simd, EnvelopeMatrix& matrix) {
    const std::int64_t blocks = (matrix.order() + column_block - 1) / column_block;
    const auto ranges = patches_by_block(patches, blocks);
    parallel_blocks(blocks, threads, [&](std::int64_t b) {
        PatchTerms terms;
        const auto range = ranges[static_cast<std::size_t>(b)];
        const std::int64_t begin = b * column_block;
        const std::int64_t end = std::min(begin + column_block, matrix.order());
        for (std::int64_t p = range.begin; p < range.end; ++p) {
            const auto frames = patches.of(p);
            if (frames.front() >= end || frames.back() <= begin)
                continue;
            terms.set(patches, p);
            terms.add_to(matrix, begin, end, simd);
        }
    });
}

void shift_diagonal(EnvelopeMatrix& matrix, double share) {
    double largest = 0;
    for (std::int64_t c = 0; c < matrix.order(); ++c)
        largest = std::max(largest, matrix.column(c)[0]);
    for (std::int64_t c = 0; c < matrix.order(); ++c)
        matrix.column(c)[0] += share * largest;
}

/// How values at a patch's frames come from differences: running sums within the patch, up to a
/// constant. Differences of far values of x would lose their digits.
struct RunningSums {
    template <class P>
    STLTSA_INLINE static void gather(const std::int32_t* frames, std::int64_t k,
                                     ConstMatrixView unknowns, std::int64_t column, P* values) {
        P sum{};
        values[0] = sum;
        for (std::int64_t j = 1; j < k; ++j) {
            for (auto c = frames[j - 1]; c < frames[j]; ++c)
                sum += pack_at<P>(unknowns.row(c) + column);
            values[j] = sum;
        }
    }
    template <class P>
    STLTSA_INLINE static void scatter(const std::int32_t* frames, std::int64_t k, const P* values,
                                      MatrixView unknowns, std::int64_t column) {
        P beyond{};
        for (std::int64_t j = k - 1; j > 0; --j) {
            beyond += values[j];
            for (auto c = frames[j - 1]; c < frames[j]; ++c)
                pack_at<P>(unknowns.row(c) + column) += beyond;
        }
    }
};

/// S^T x: sums of the values beyond each difference.
struct SuffixSums {
    ConstMatrixView x;
    MatrixView unknowns;

    template <int W>
    STLTSA_INLINE void run() const {
        for_columns<W>(x.cols, *this);
    }
    template <class P>
    STLTSA_INLINE void columns(std::int64_t column) const {
        P sum{};
        for (std::int64_t c = unknowns.rows; c-- > 0;) {
            sum += pack_at<P>(x.row(c + 1) + column);
            pack_at<P>(unknowns.row(c) + column) = sum;
        }
    }
};

/// S z
struct PrefixSums {
    ConstMatrixView unknowns;
    MatrixView x;

    template <int W>
    STLTSA_INLINE void run() const {
        for_columns<W>(x.cols, *this);
    }
    template <class P>
    STLTSA_INLINE void columns(std::int64_t column) const {
        P sum{};
        pack_at<P>(x.row(0) + column) = sum;
        for (std::int64_t c = 0; c < unknowns.rows; ++c) {
            sum += pack_at<P>(unknowns.row(c) + column);
            pack_at<P>(x.row(c + 1) + column) = sum;
        }
    }
};

class DifferenceAlignment final : public PassingAlignment<RunningSums> {
  public:
    DifferenceAlignment(const Patches& patches, int threads, Simd simd)
        : PassingAlignment(patches, simd), factor_(envelope_of(patches)) {
        assemble(patches, threads, simd, factor_);
        if (cholesky(factor_, smallest_pivot, simd))
            return;
        factor_ = EnvelopeMatrix(envelope_of(patches));
        assemble(patches, threads, simd, factor_);
        shift_diagonal(factor_, flat_shift);
        if (!cholesky(factor_, 0, simd))
            fail(Status::degenerate, "the frames do not vary in {} directions",
                 patches.dimension());
    }

    void restrict_to(ConstMatrixView x, MatrixView unknowns) const override {
        run_simd(simd_, SuffixSums{x, unknowns});
    }
    void prolong(ConstMatrixView unknowns, MatrixView x) const override {
        run_simd(simd_, PrefixSums{unknowns, x});
        center(x, simd_);
    }
    void solve(MatrixView unknowns) const override { cholesky_solve(factor_, unknowns, simd_); }

  private:
    EnvelopeMatrix factor_;
};

} // namespace

std::unique_ptr<Alignment> difference_alignment(const Patches& patches, int threads, Simd simd) {
    return std::make_unique<DifferenceAlignment>(patches, threads, simd);
}

} // namespace stltsa::ltsa
