// SPDX-License-Identifier: BSD-3-Clause
// Alignment for neighborhoods that reach anywhere: the value of the last frame is set to zero, so
// the remaining rows and columns of B are regular, and a solution, centered, is that of the
// pseudo-inverse. Differences would fill the matrix here.
#include "ltsa/alignment/alignment.hpp"

#ifdef STLTSA_CHOLMOD
#include <algorithm>

#include "linalg/simd.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "ltsa/alignment/patch_passes.hpp"
#endif

namespace stltsa::ltsa {

#ifdef STLTSA_CHOLMOD
namespace {

/// Which patches hold a frame, and where: the patches of frame f are entries
/// begin[f] .. begin[f + 1] - 1, ascending.
struct Holders {
    struct Place {
        std::int32_t patch, position;
    };
    std::vector<std::int64_t> begin;
    std::vector<Place> places;
};

Holders holders_of(const Patches& patches) {
    Holders holders;
    holders.begin.assign(static_cast<std::size_t>(patches.frames()) + 1, 0);
    for (std::int64_t p = 0; p < patches.count(); ++p)
        for (const std::int32_t frame : patches.of(p))
            ++holders.begin[static_cast<std::size_t>(frame) + 1];
    for (std::size_t f = 1; f < holders.begin.size(); ++f)
        holders.begin[f] += holders.begin[f - 1];
    holders.places.resize(static_cast<std::size_t>(holders.begin.back()));
    auto next = holders.begin;
    for (std::int64_t p = 0; p < patches.count(); ++p) {
        std::int32_t position = 0;
        for (const std::int32_t frame : patches.of(p))
            holders.places[static_cast<std::size_t>(next[static_cast<std::size_t>(frame)]++)] = {
                static_cast<std::int32_t>(p), position++};
    }
    return holders;
}

/// Column `column` of B from its diagonal down, summed patch by patch in fixed order.
class ColumnSum {
  public:
    ColumnSum(const Patches& patches, const Holders& holders)
        : patches_(patches), holders_(holders), value_(static_cast<std::size_t>(patches.frames())),
          seen_(static_cast<std::size_t>(patches.frames()), -1) {}

    void compute(std::int64_t column) {
        rows.clear();
        const auto begin = holders_.begin[static_cast<std::size_t>(column)];
        const auto end = holders_.begin[static_cast<std::size_t>(column) + 1];
        for (auto at = begin; at < end; ++at)
            add(holders_.places[static_cast<std::size_t>(at)], column);
        std::sort(rows.begin(), rows.end());
    }

    std::vector<std::int32_t> rows;
    double value(std::int32_t row) const { return value_[static_cast<std::size_t>(row)]; }

  private:
    void add(Holders::Place place, std::int64_t column) {
        const auto frames =
            patches_.of(place.patch).subspan(static_cast<std::size_t>(place.position));
        fill_terms(place, static_cast<std::int64_t>(frames.size()));
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
    void fill_terms(Holders::Place place, std::int64_t count) {
        terms_.assign(static_cast<std::size_t>(count), -1.0 / static_cast<double>(patches_.size()));
        terms_[0] += 1;
        for (std::int64_t l = 0; l < patches_.dimension(); ++l) {
            const double* g = patches_.direction(place.patch, l) + place.position;
            axpy(-*g, g, terms_.data(), count);
        }
    }

    const Patches& patches_;
    const Holders& holders_;
    std::vector<double> value_;
    std::vector<std::int64_t> seen_; ///< column for which a value was started
    AlignedVector<double> terms_;
};

SparseColumns assemble(const Patches& patches) {
    const Holders holders = holders_of(patches);
    ColumnSum sum(patches, holders);
    const std::int64_t order = patches.frames() - 1; // the last frame is the ground
    SparseColumns matrix{order, {0}, {}, {}};
    for (std::int64_t column = 0; column < order; ++column) {
        sum.compute(column);
        for (const std::int32_t row : sum.rows)
            if (row < order) {
                matrix.rows.push_back(row);
                matrix.values.push_back(sum.value(row));
            }
        matrix.begin.push_back(static_cast<std::int64_t>(matrix.rows.size()));
    }
    return matrix;
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

class GroundedAlignment final : public PassingAlignment<GroundedValues> {
  public:
    GroundedAlignment(const Patches& patches, const Machine& machine)
        : PassingAlignment(patches, machine), factor_(assemble(patches)) {}

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
#else
std::unique_ptr<Alignment> grounded_alignment(const Patches&, const Machine&) {
    fail(Status::unsupported, "the modes spatial and recurrent need SuiteSparse CHOLMOD, and this "
                              "library was built without it (-Dcholmod=disabled); use temporal");
}
#endif

} // namespace stltsa::ltsa
