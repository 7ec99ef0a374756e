// SPDX-License-Identifier: BSD-3-Clause
// Alignment for neighborhoods without a band. The value of the last frame is fixed at zero (it is
// grounded): the remaining rows and columns of B are regular, and a centered solution is that of
// the pseudo-inverse. Differences would fill the matrix here.
#include "base/checkpoint.hpp"
#include "ltsa/alignment/alignment.hpp"

#include <algorithm>

#include "linalg/simd.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "ltsa/alignment/patch_passes.hpp"

namespace stltsa::ltsa {
namespace {

/// The patches that contain each frame, and the frame's position there: entries begin[f] ..
/// begin[f + 1] - 1 for frame f, with patches ascending.
struct PatchesByFrame {
    struct Occurrence {
        std::int32_t patch, position;
    };
    std::vector<std::int64_t> begin;
    std::vector<Occurrence> occurrences;

    std::int64_t count(std::int64_t frame) const {
        return begin[static_cast<std::size_t>(frame) + 1] - begin[static_cast<std::size_t>(frame)];
    }
};

PatchesByFrame patches_by_frame(const Patches& patches) {
    PatchesByFrame by_frame;
    by_frame.begin.assign(static_cast<std::size_t>(patches.frames()) + 1, 0);
    for (std::int64_t p = 0; p < patches.count(); ++p)
        for (const std::int32_t frame : patches.of(p))
            ++by_frame.begin[static_cast<std::size_t>(frame) + 1];
    for (std::size_t f = 1; f < by_frame.begin.size(); ++f)
        by_frame.begin[f] += by_frame.begin[f - 1];
    by_frame.occurrences.resize(static_cast<std::size_t>(by_frame.begin.back()));
    auto next = by_frame.begin;
    for (std::int64_t p = 0; p < patches.count(); ++p) {
        std::int32_t position = 0;
        for (const std::int32_t frame : patches.of(p)) {
            const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(frame)]++);
            by_frame.occurrences[at] = {static_cast<std::int32_t>(p), position++};
        }
    }
    return by_frame;
}

/// A column of B from its diagonal down, summed over the patches in fixed order.
class ColumnOfB {
  public:
    ColumnOfB(const Patches& patches, const PatchesByFrame& by_frame)
        : patches_(patches), by_frame_(by_frame),
          value_(static_cast<std::size_t>(patches.frames())),
          seen_(static_cast<std::size_t>(patches.frames()), -1) {}

    void compute(std::int64_t column) {
        rows.clear();
        const auto begin = by_frame_.begin[static_cast<std::size_t>(column)];
        const auto end = by_frame_.begin[static_cast<std::size_t>(column) + 1];
        for (auto at = begin; at < end; ++at)
            add(by_frame_.occurrences[static_cast<std::size_t>(at)], column);
        std::sort(rows.begin(), rows.end());
    }

    std::vector<std::int32_t> rows;
    double value(std::int32_t row) const { return value_[static_cast<std::size_t>(row)]; }

  private:
    void add(PatchesByFrame::Occurrence occurrence, std::int64_t column) {
        const auto frames =
            patches_.of(occurrence.patch).subspan(static_cast<std::size_t>(occurrence.position));
        fill_terms(occurrence, static_cast<std::int64_t>(frames.size()));
        for (std::size_t j = 0; j < frames.size(); ++j) {
            const auto row = static_cast<std::size_t>(frames[j]);
            if (seen_[row] != column) {
                seen_[row] = column;
                value_[row] = 0;
                rows.push_back(frames[j]);
            }
            value_[row] += terms_[j];
        }
    }
    /// The contribution of a patch to a column, beginning with the column's own frame.
    void fill_terms(PatchesByFrame::Occurrence occurrence, std::int64_t count) {
        terms_.assign(static_cast<std::size_t>(count), -1.0 / static_cast<double>(patches_.size()));
        terms_[0] += 1;
        for (std::int64_t l = 0; l < patches_.dimension(); ++l) {
            const double* g = patches_.direction(occurrence.patch, l) + occurrence.position;
            axpy(-*g, g, terms_.data(), count);
        }
    }

    const Patches& patches_;
    const PatchesByFrame& by_frame_;
    std::vector<double> value_;
    std::vector<std::int64_t> seen_; ///< the column that the value belongs to
    AlignedVector<double> terms_;
};

/// Table 1, step 4: B without the last row and column, which belong to the grounded frame.
SparseColumns assemble_b(const Patches& patches) {
    const PatchesByFrame by_frame = patches_by_frame(patches);
    ColumnOfB entries(patches, by_frame);
    const std::int64_t order = patches.frames() - 1;
    SparseColumns b{order, {0}, {}, {}};
    for (std::int64_t column = 0; column < order; ++column) {
        entries.compute(column);
        for (const std::int32_t row : entries.rows)
            if (row < order) {
                b.rows.push_back(row);
                b.values.push_back(entries.value(row));
            }
        b.begin.push_back(static_cast<std::int64_t>(b.rows.size()));
        checkpoint(by_frame.count(column) * patches.size());
    }
    return b;
}

/// Values at a patch's frames are the unknowns themselves, except at the grounded frame.
struct GroundedValues {
    template <class P>
    STLTSA_INLINE static void gather(const std::int32_t* frames, std::int64_t k,
                                     ConstMatrixView unknowns, std::int64_t column, P* values) {
        for (std::int64_t j = 0; j < k; ++j)
            values[j] =
                frames[j] < unknowns.rows ? pack_at<P>(unknowns.row(frames[j]) + column) : P{};
    }
    template <class P>
    STLTSA_INLINE static void scatter(const std::int32_t* frames, std::int64_t k, const P* values,
                                      MatrixView unknowns, std::int64_t column) {
        for (std::int64_t j = 0; j < k; ++j)
            if (frames[j] < unknowns.rows)
                pack_at<P>(unknowns.row(frames[j]) + column) += values[j];
    }
};

class GroundedAlignment final : public PatchwiseAlignment<GroundedValues> {
  public:
    GroundedAlignment(const Patches& patches, const Machine& machine)
        : PatchwiseAlignment(patches, machine), factor_(assemble_b(patches)) {}

    void restrict_to(ConstMatrixView x, MatrixView unknowns) const override {
        std::copy_n(x.data, unknowns.rows * unknowns.cols, unknowns.data);
        subtract_row(unknowns, column_means(x, machine_), machine_);
    }
    void at_frames(ConstMatrixView right, MatrixView x) const override {
        std::copy_n(right.data, right.rows * right.cols, x.data);
        double* ground = x.row(right.rows);
        std::fill_n(ground, x.cols, 0.0);
        for (std::int64_t i = 0; i < right.rows; ++i)
            for (std::int64_t c = 0; c < x.cols; ++c)
                ground[c] -= right(i, c);
    }
    void prolong(ConstMatrixView unknowns, MatrixView x) const override {
        std::copy_n(unknowns.data, unknowns.rows * unknowns.cols, x.data);
        std::fill_n(x.row(x.rows - 1), x.cols, 0.0);
        center(x, machine_);
    }

  private:
    void solve_rows(MatrixView rows) const override { factor_.solve(rows); }

    SparseCholesky factor_;
};

} // namespace

std::unique_ptr<Alignment> grounded_alignment(const Patches& patches, const Machine& machine) {
    return std::make_unique<GroundedAlignment>(patches, machine);
}

} // namespace stltsa::ltsa
