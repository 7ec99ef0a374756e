// SPDX-License-Identifier: BSD-3-Clause
// The rows of I - e e^T/k - G G^T sum to zero, so each neighborhood with frames p_0 < .. < p_{k-1}
// adds to B' its own term: for p_0 <= c <= c' < p_{k-1}, with a(c) the number of its frames beyond
// difference c and h_l(c) the sum of g_l over them,
//     B'(c', c) += a(c') (k - a(c)) / k - sum_l h_l(c') h_l(c).
#include "ltsa/alignment/band_of_b.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include <cblas.h>

#include "linalg/simd.hpp"
#include "ltsa/alignment/column_blocks.hpp"

namespace stltsa::ltsa {

namespace {

/// Assembles the columns [begin, end) of B' on one thread.
class ColumnsOfB {
  public:
    ColumnsOfB(const Patches& patches, std::int64_t begin, std::int64_t end, BandMatrix& b)
        : patches_(patches), begin_(begin), end_(end), b_(b) {}

    /// Writes the sum of a(c') (k - a(c)) / k. From one column to the next, a(c') (k - a(c)) grows
    /// by a(c') if the patch contains frame c. This increment changes only where consecutive frames
    /// of the patch begin or end, so columns get these changes, and two running sums give the
    /// values. All are integers, exact in any order, until the division by k.
    void set_counts(PatchRange range) {
        std::fill(b_.column(begin_), b_.column(end_), 0.0);
        before_.assign(static_cast<std::size_t>(b_.bandwidth()), 0);
        for (std::int64_t p = range.begin; p < range.end; ++p)
            add_changes(patches_.of(p));
        const double inverse_size = 1 / static_cast<double>(patches_.size());
        const double* before = before_.data();
        for (std::int64_t c = begin_; c < end_; ++c) {
            double* column = b_.column(c);
            if (c + 1 < end_)
                axpy(1, column + 1, b_.column(c + 1), b_.bandwidth());
            axpy(1, before, column, b_.bandwidth());
            before = column + 1;
            if (c > begin_)
                scale(b_.column(c - 1), inverse_size);
        }
        scale(b_.column(end_ - 1), inverse_size);
    }

    /// Subtracts h_l(c') h_l(c) for these patches, as one matrix product in which each patch is
    /// padded with zeros.
    void subtract_directions(std::int64_t begin, std::int64_t end) {
        std::int64_t first = patches_.frames(), last = 0;
        for (std::int64_t p = begin; p < end; ++p) {
            first = std::min<std::int64_t>(first, patches_.of(p).front());
            last = std::max<std::int64_t>(last, patches_.of(p).back());
        }
        if (first >= end_ || last <= begin_)
            return;
        const std::int64_t length = last - first;
        const std::int64_t rank = (end - begin) * patches_.dimension();
        sums_.assign(checked_size(length, rank), 0);
        for (std::int64_t p = begin; p < end; ++p)
            write_sums(p, length,
                       sums_.data() + (p - begin) * patches_.dimension() * length +
                           (patches_.of(p).front() - first));
        product_.resize(checked_size(length, length));
        cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, static_cast<int>(length),
                    static_cast<int>(rank), -1, sums_.data(), static_cast<int>(length), 0,
                    product_.data(), static_cast<int>(length));
        for (std::int64_t c = std::max(first, begin_); c < std::min(last, end_); ++c)
            axpy(1, product_.data() + (c - first) * (length + 1), b_.column(c),
                 std::min(b_.bandwidth() + 1, last - c));
    }

  private:
    void scale(double* column, double inverse_size) const {
        for (std::int64_t i = 0; i <= b_.bandwidth(); ++i)
            column[i] *= inverse_size;
    }

    void add_changes(std::span<const std::int32_t> frames) {
        if (frames.back() <= begin_ || frames.front() >= end_)
            return;
        beyond_.resize(static_cast<std::size_t>(frames.back() - frames.front()));
        for (std::size_t j = 0; j + 1 < frames.size(); ++j)
            std::fill(beyond_.begin() + (frames[j] - frames.front()),
                      beyond_.begin() + (frames[j + 1] - frames.front()),
                      static_cast<double>(frames.size() - 1 - j));
        const auto change = [&](double factor, std::int64_t column, double* to) {
            axpy(factor, beyond_.data() + (column - frames.front()), to, frames.back() - column);
        };
        if (frames.front() <= begin_) {
            const double has = std::ranges::binary_search(frames, begin_) ? 1 : 0;
            const double beyond = beyond_[static_cast<std::size_t>(begin_ - frames.front())];
            if (frames.front() < begin_) // else it does not touch the previous column
                change(static_cast<double>(frames.size()) - beyond - has, begin_, before_.data());
            change(has, begin_, b_.column(begin_));
        }
        for (std::size_t j = 0; j < frames.size(); ++j) {
            const std::int64_t frame = frames[j];
            if ((j == 0 || frames[j - 1] + 1 < frame) && begin_ < frame && frame < end_)
                change(1, frame, b_.column(frame));
            if (j + 1 < frames.size() && frame + 1 < frames[j + 1] && begin_ <= frame &&
                frame + 1 < end_)
                change(-1, frame + 1, b_.column(frame + 1));
        }
    }

    /// Writes h_1, h_2, .., `stride` entries apart, with opposite sign: as sums over the frames
    /// before each difference, because g_l is orthogonal to e.
    void write_sums(std::int64_t patch, std::int64_t stride, double* to) const {
        const auto frames = patches_.of(patch);
        to -= frames.front();
        for (std::int64_t l = 0; l < patches_.dimension(); ++l, to += stride) {
            const double* g = patches_.direction(patch, l);
            double sum = 0;
            for (std::size_t j = 0; j + 1 < frames.size(); ++j) {
                sum += g[j];
                for (auto c = frames[j]; c < frames[j + 1]; ++c)
                    to[c] = sum;
            }
        }
    }

    const Patches& patches_;
    std::int64_t begin_, end_;
    BandMatrix& b_;
    std::vector<double> beyond_; ///< a, of one patch
    std::vector<double> before_; ///< entries of column begin - 1 in the rows of column begin
    AlignedVector<double> sums_, product_;
};

/// Patches of one product: larger products are faster, but padded with more zeros.
constexpr std::int64_t patches_per_product = 16;

/// Columns of a block; products at its borders are computed twice.
constexpr std::int64_t column_block = 2048;

} // namespace

std::int64_t bandwidth_of(const Patches& patches) {
    std::int64_t longest = 0;
    for (std::int64_t p = 0; p < patches.count(); ++p)
        longest = std::max<std::int64_t>(longest, patches.of(p).back() - patches.of(p).front() - 1);
    return longest;
}

void assemble_b(const Patches& patches, int threads, BandMatrix& b) {
    for_column_blocks(
        patches, b.order(), column_block, threads,
        [&](std::int64_t begin, std::int64_t end, PatchRange range) {
            ColumnsOfB columns(patches, begin, end, b);
            columns.set_counts(range);
            // Products contain the same patches in every block.
            for (std::int64_t p = range.begin / patches_per_product * patches_per_product;
                 p < range.end; p += patches_per_product)
                columns.subtract_directions(p, std::min(p + patches_per_product, patches.count()));
        });
}

} // namespace stltsa::ltsa
