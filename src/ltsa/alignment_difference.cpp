// SPDX-License-Identifier: BSD-3-Clause
// Alignment in differences. With x = S z (S the running sum), B' = S^T B S keeps the band of B, has
// no null vector, and its smallest eigenvalues are larger by about n^2.
#include "ltsa/alignment.hpp"

#include <algorithm>
#include <memory>

#include "linalg/run_sums.hpp"
#include "ltsa/difference_terms.hpp"
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

/// How values at a patch's frames come from differences: running sums from the middle of the patch
/// to both sides, up to a constant. Differences of far values of x would lose their digits. The two
/// sides take turns, as neither waits for the other.
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

/// B' of a narrow band: a few entries to a column.
class NarrowBand {
  public:
    NarrowBand(const Patches& patches, const Envelope& envelope, const Machine& machine)
        : machine_(machine), matrix_(envelope, machine) {
        assemble(patches, machine, matrix_);
    }
    std::int64_t order() const { return matrix_.order(); }
    double& diagonal(std::int64_t c) { return matrix_.entry(c, c); }
    bool factor(double smallest) { return cholesky(matrix_, smallest, machine_); }
    void solve(MatrixView unknowns) const { cholesky_solve(matrix_, unknowns, machine_); }

  private:
    Machine machine_;
    EnvelopeMatrix matrix_;
};

/// B' of a wide band, where BLAS is quicker.
class WideBand {
  public:
    WideBand(const Patches& patches, const Envelope& envelope, const Machine& machine)
        : matrix_(envelope) {
        assemble(patches, machine, matrix_);
    }
    std::int64_t order() const { return matrix_.order(); }
    double& diagonal(std::int64_t c) { return matrix_.diagonal(c); }
    bool factor(double smallest) { return cholesky(matrix_, smallest); }
    void solve(MatrixView unknowns) const { cholesky_solve(matrix_, unknowns); }

  private:
    BlockEnvelopeMatrix matrix_;
};

template <class Band>
void shift_diagonal(Band& band, double share) {
    double largest = 0;
    for (std::int64_t c = 0; c < band.order(); ++c)
        largest = std::max(largest, band.diagonal(c));
    for (std::int64_t c = 0; c < band.order(); ++c)
        band.diagonal(c) += share * largest;
}

template <class Band>
class DifferenceAlignment final : public PassingAlignment<RunningSums> {
  public:
    DifferenceAlignment(const Patches& patches, const Envelope& envelope, const Machine& machine)
        : PassingAlignment(patches, machine),
          factor_(std::make_unique<Band>(patches, envelope, machine)) {
        if (factor_->factor(smallest_pivot))
            return;
        factor_.reset(); // before the next one takes as much memory
        factor_ = std::make_unique<Band>(patches, envelope, machine);
        shift_diagonal(*factor_, flat_shift);
        if (!factor_->factor(0))
            fail(Status::degenerate, "the frames do not vary in {} directions",
                 patches.dimension());
    }

    void restrict_to(const Aggregation& runs, ConstMatrixView x,
                     MatrixView unknowns) const override {
        centered_suffix_sums(runs, x, unknowns, machine_);
    }
    void prolong(ConstMatrixView unknowns, const Aggregation& runs, MatrixView x) const override {
        centered_prefix_sums(unknowns, runs, x, machine_);
    }
    void solve(MatrixView unknowns) const override { factor_->solve(unknowns); }
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
    std::unique_ptr<Band> factor_;
};

/// Entries of a column, in the mean, from which on a band is wide.
constexpr std::int64_t wide = 64;

std::int64_t entries_of(const Envelope& envelope) {
    std::int64_t entries = 0;
    for (std::size_t c = 0; c < envelope.size(); ++c)
        entries += envelope[c] - static_cast<std::int64_t>(c) + 1;
    return entries;
}

} // namespace

std::unique_ptr<Alignment> difference_alignment(const Patches& patches, const Machine& machine) {
    const Envelope envelope = envelope_of(patches, machine);
    if (entries_of(envelope) < wide * static_cast<std::int64_t>(envelope.size()))
        return std::make_unique<DifferenceAlignment<NarrowBand>>(patches, envelope, machine);
    return std::make_unique<DifferenceAlignment<WideBand>>(patches, envelope, machine);
}

} // namespace stltsa::ltsa
