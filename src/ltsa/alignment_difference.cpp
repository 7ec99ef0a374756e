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

/// One patch spread over the differences it covers.
class PatchTerms {
  public:
    explicit PatchTerms(std::int64_t dimension) : sums_(static_cast<std::size_t>(dimension)) {}

    void set(const Patches& patches, std::int64_t patch) {
        const auto frames = patches.of(patch);
        first_ = frames.front();
        const auto span = static_cast<std::size_t>(frames.back() - frames.front());
        const auto k = static_cast<std::size_t>(patches.size());
        beyond_.resize(span);
        for (auto& sum : sums_)
            sum.resize(span);
        std::size_t next = k; // frames[next] is the first one beyond c
        std::vector<double>& h = suffix_;
        h.assign(sums_.size(), 0.0);
        for (std::size_t c = span; c-- > 0;) {
            while (next > 0 && static_cast<std::size_t>(frames[next - 1] - first_) > c) {
                --next;
                for (std::size_t l = 0; l < sums_.size(); ++l)
                    h[l] += patches.direction(patch, static_cast<std::int64_t>(l))[next];
            }
            beyond_[c] = static_cast<double>(k - next);
            for (std::size_t l = 0; l < sums_.size(); ++l)
                sums_[l][c] = h[l];
        }
        size_ = static_cast<double>(k);
    }

    /// Adds this patch's part of the columns [begin, end).
    void add_to(EnvelopeMatrix& matrix, std::int64_t begin, std::int64_t end) const {
        const auto span = static_cast<std::int64_t>(beyond_.size());
        for (std::int64_t c = std::max(begin, first_); c < std::min(end, first_ + span); ++c) {
            double* column = matrix.column(c);
            const double* a = beyond_.data() + (c - first_);
            const std::int64_t length = span - (c - first_);
            const double before = (size_ - a[0]) / size_;
            for (std::int64_t r = 0; r < length; ++r)
                column[r] += a[r] * before;
            for (const auto& sum : sums_) {
                const double* h = sum.data() + (c - first_);
                for (std::int64_t r = 0; r < length; ++r)
                    column[r] -= h[0] * h[r];
            }
        }
    }

  private:
    std::int64_t first_ = 0;
    double size_ = 0;
    std::vector<double> beyond_;
    std::vector<std::vector<double>> sums_;
    std::vector<double> suffix_;
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
void assemble(const Patches& patches, int threads, EnvelopeMatrix& matrix) {
    const std::int64_t blocks = (matrix.order() + column_block - 1) / column_block;
    const auto ranges = patches_by_block(patches, blocks);
    parallel_blocks(blocks, threads, [&](std::int64_t b) {
        PatchTerms terms(patches.dimension());
        const auto range = ranges[static_cast<std::size_t>(b)];
        const std::int64_t begin = b * column_block;
        const std::int64_t end = std::min(begin + column_block, matrix.order());
        for (std::int64_t p = range.begin; p < range.end; ++p) {
            const auto frames = patches.of(p);
            if (frames.front() >= end || frames.back() <= begin)
                continue;
            terms.set(patches, p);
            terms.add_to(matrix, begin, end);
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
        assemble(patches, threads, factor_);
        if (cholesky(factor_, smallest_pivot))
            return;
        factor_ = EnvelopeMatrix(envelope_of(patches));
        assemble(patches, threads, factor_);
        shift_diagonal(factor_, flat_shift);
        if (!cholesky(factor_, 0))
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
