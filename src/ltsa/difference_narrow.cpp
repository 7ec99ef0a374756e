// SPDX-License-Identifier: BSD-3-Clause
// B' of a narrow band: patch after patch, difference by difference.
#include <algorithm>
#include <vector>

#include "linalg/simd.hpp"
#include "ltsa/column_blocks.hpp"
#include "ltsa/difference_terms.hpp"

namespace stltsa::ltsa {

namespace {

/// One patch spread over the differences that it covers, in the order of one arm of the matrix:
/// `span` of them from the first one on.
class PatchTerms {
  public:
    void set(const Patches& patches, std::int64_t patch, Order order);

    std::int64_t first() const { return first_; }
    std::int64_t span() const { return span_; }
    std::int64_t dimension() const { return dimension_; }
    /// k
    double size() const { return size_; }
    /// a
    const double* beyond() const { return values_.data(); }
    /// h_0, then h_1, ...
    const double* sums() const { return values_.data() + span_; }

  private:
    std::int64_t first_ = 0;
    std::int64_t span_ = 0;
    std::int64_t dimension_ = 0;
    double size_ = 0;
    std::vector<double> values_;
};

void PatchTerms::set(const Patches& patches, std::int64_t patch, Order order) {
    const auto frames = patches.of(patch);
    size_ = static_cast<double>(patches.size());
    first_ = order == Order::of_time ? frames.front() : patches.frames() - 1 - frames.back();
    span_ = frames.back() - frames.front();
    dimension_ = patches.dimension();
    values_.resize(static_cast<std::size_t>(span_ * (1 + dimension_)));
    spread_counts(patches, patch, order, values_.data());
    spread_directions(patches, patch, order, values_.data() + span_, span_);
}

/// Adds one patch's part of the columns [begin, end):
///     column[r] += a[r] before - sum_l h_l[0] h_l[r]
struct AddPatch {
    EnvelopeColumns& matrix;
    std::int64_t begin, end;
    const PatchTerms& terms;

    template <int W>
    STLTSA_INLINE void run() const {
        const std::int64_t first = terms.first();
        const std::int64_t rows = std::min(terms.span(), matrix.order() - first);
        for (std::int64_t c = std::max(begin, first); c < std::min(end, first + rows); ++c) {
            double* column = matrix.column(c);
            const std::int64_t from = c - first;
            const std::int64_t length = rows - from;
            const double before = (terms.size() - terms.beyond()[from]) / terms.size();
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
        P value = load<P>(column + r) + load<P>(terms.beyond() + from + r) * before;
        for (std::int64_t l = 0; l < terms.dimension(); ++l) {
            const double* h = terms.sums() + l * terms.span() + from;
            value -= h[0] * load<P>(h + r);
        }
        return value;
    }
};

/// Columns that one thread assembles at a time; patches at their borders are spread twice.
constexpr std::int64_t column_block = 512;

/// The differences [begin, end), whose entries one arm has.
struct Part {
    std::int64_t begin, end;
    Order order;
};

void assemble_part(const Patches& patches, PatchRange range, Part part, Simd simd,
                   EnvelopeMatrix& matrix) {
    if (part.begin == part.end)
        return;
    const bool of_time = part.order == Order::of_time;
    EnvelopeColumns& columns = matrix.arm(of_time ? 0 : 1).columns;
    const std::int64_t begin = of_time ? part.begin : matrix.order() - part.end;
    const std::int64_t end = of_time ? part.end : matrix.order() - part.begin;
    columns.clear(begin, end);
    PatchTerms terms;
    for (std::int64_t p = range.begin; p < range.end; ++p) {
        const auto frames = patches.of(p);
        if (frames.front() >= part.end || frames.back() <= part.begin)
            continue;
        terms.set(patches, p, part.order);
        run_simd(simd, AddPatch{columns, begin, end, terms});
    }
}

} // namespace

void assemble(const Patches& patches, const Machine& machine, EnvelopeMatrix& matrix) {
    for_column_blocks(
        patches, matrix.order(), column_block, machine.threads,
        [&](std::int64_t begin, std::int64_t end, PatchRange range) {
            const std::int64_t between = std::clamp(matrix.middle_end(), begin, end);
            assemble_part(patches, range, {begin, between, Order::of_time}, machine.simd, matrix);
            assemble_part(patches, range, {between, end, Order::reversed}, machine.simd, matrix);
        });
}

} // namespace stltsa::ltsa
