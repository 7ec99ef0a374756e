// SPDX-License-Identifier: BSD-3-Clause
// Alignment in differences: with x = S z (S the running sum), B' = S^T B S keeps the band of B but
// has no null vector, and its smallest eigenvalues are larger by about n^2.
#include "ltsa/alignment/alignment.hpp"

#include <algorithm>
#include <memory>

#include "ltsa/alignment/band_of_b.hpp"
#include "ltsa/alignment/patch_passes.hpp"

namespace stltsa::ltsa {
namespace {

/// A pivot below this share of its diagonal entry means a flat direction. Others stay above 5e-5 on
/// motion and on smooth synthetic curves; flat ones are below 1e-16.
constexpr double smallest_pivot = 1e-13;

/// Frames in a flat space of d dimensions make B' singular: the embedding is its null space. A
/// shift of this share of the largest diagonal entry then replaces the zero eigenvalues, and
/// inverse iteration through the patches removes its effect on the vectors.
constexpr double flat_shift = 1e-13;

/// Values at a patch's frames from differences, up to a constant: running sums from the middle of
/// the patch to both sides. Subtracting distant values of x would lose digits. The two sides
/// alternate, because neither depends on the other.
struct RunningSums {
    template <class P>
    STLTSA_INLINE static void gather(const std::int32_t* frames, std::int64_t k,
                                     ConstMatrixView unknowns, std::int64_t column, P* values) {
        const std::int64_t middle = k / 2;
        P before{}, after{};
        values[middle] = P{};
        for (std::int64_t step = 1; step <= middle; ++step) {
            const std::int64_t left = middle - step;
            for (auto c = frames[left + 1] - 1; c >= frames[left]; --c)
                before -= pack_at<P>(unknowns.row(c) + column);
            values[left] = before;
            const std::int64_t right = middle + step;
            if (right == k)
                break;
            for (auto c = frames[right - 1]; c < frames[right]; ++c)
                after += pack_at<P>(unknowns.row(c) + column);
            values[right] = after;
        }
    }
    template <class P>
    STLTSA_INLINE static void scatter(const std::int32_t* frames, std::int64_t k, const P* values,
                                      MatrixView unknowns, std::int64_t column) {
        const std::int64_t middle = k / 2;
        P before{}, after{};
        for (std::int64_t left = 0; left < middle; ++left) {
            before += values[left];
            for (auto c = frames[left]; c < frames[left + 1]; ++c)
                pack_at<P>(unknowns.row(c) + column) -= before;
            const std::int64_t right = k - 1 - left;
            if (right <= middle)
                break;
            after += values[right];
            for (auto c = frames[right - 1]; c < frames[right]; ++c)
                pack_at<P>(unknowns.row(c) + column) += after;
        }
    }
};

void shift_diagonal(BandMatrix& b, double share) {
    double largest = 0;
    for (std::int64_t c = 0; c < b.order(); ++c)
        largest = std::max(largest, *b.column(c));
    for (std::int64_t c = 0; c < b.order(); ++c)
        *b.column(c) += share * largest;
}

class DifferenceAlignment final : public PatchwiseAlignment<RunningSums> {
  public:
    DifferenceAlignment(const Patches& patches, const Machine& machine)
        : PatchwiseAlignment(patches, machine), b_(patches.frames() - 1, bandwidth_of(patches)) {
        assemble_b(patches, machine.threads, b_);
        if (b_.factor(smallest_pivot))
            return;
        assemble_b(patches, machine.threads, b_);
        shift_diagonal(b_, flat_shift);
        if (!b_.factor(0))
            fail(Status::degenerate, "the frames vary in fewer than {} directions",
                 patches.dimension());
    }

    void restrict_to(ConstMatrixView x, MatrixView unknowns) const override {
        running_sums(x.block(0, unknowns.rows), -1, column_means(x, machine_), unknowns, machine_);
    }
    void prolong(ConstMatrixView unknowns, MatrixView x) const override {
        std::fill_n(x.row(0), x.cols, 0.0);
        running_sums(unknowns, 1, Matrix(1, x.cols), x.block(1, unknowns.rows), machine_);
        center(x, machine_);
    }
    void at_frames(ConstMatrixView right, MatrixView x) const override {
        for (std::int64_t c = 0; c < x.cols; ++c) {
            x(0, c) = -right(0, c);
            x(right.rows, c) = right(right.rows - 1, c);
        }
        for_row_blocks(right.rows - 1, machine_,
                       [&](std::int64_t, std::int64_t first, std::int64_t rows) {
                           for (std::int64_t i = first; i < first + rows; ++i)
                               for (std::int64_t c = 0; c < x.cols; ++c)
                                   x(i + 1, c) = right(i, c) - right(i + 1, c);
                       });
    }

  private:
    void solve_rows(MatrixView rows) const override { b_.solve(rows, machine_); }

    BandMatrix b_;
};

} // namespace

std::unique_ptr<Alignment> difference_alignment(const Patches& patches, const Machine& machine) {
    return std::make_unique<DifferenceAlignment>(patches, machine);
}

} // namespace stltsa::ltsa
