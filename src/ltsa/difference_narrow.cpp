// SPDX-License-Identifier: BSD-3-Clause
// B' of a narrow band: patch after patch, difference by difference.
#include <algorithm>
#include <vector>

#include "linalg/simd.hpp"
#include "ltsa/column_blocks.hpp"
#include "ltsa/difference_terms.hpp"

namespace stltsa::ltsa {

namespace {

/// One patch spread over the differences that it covers: `span` of them from the first one on.
class PatchTerms {
  public:
    void set(const Patches& patches, std::int64_t patch);

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

void PatchTerms::set(const Patches& patches, std::int64_t patch) {
    const auto frames = patches.of(patch);
    size_ = static_cast<double>(patches.size());
    first_ = frames.front();
    span_ = frames.back() - frames.front();
    dimension_ = patches.dimension();
    values_.resize(static_cast<std::size_t>(span_ * (1 + dimension_)));
    spread_counts(patches, patch, values_.data());
    spread_directions(patches, patch, values_.data() + span_, span_);
}

/// Adds one patch's part of the columns [begin, end):
///     column[r] += a[r] before - sum_l h_l[0] h_l[r]
struct AddPatch {
    EnvelopeMatrix& matrix;
    std::int64_t begin, end;
    const PatchTerms& terms;

    template <int W>
    STLTSA_INLINE void run() const {
        const std::int64_t first = terms.first();
        const std::int64_t span = terms.span();
        for (std::int64_t c = std::max(begin, first); c < std::min(end, first + span); ++c) {
            double* column = matrix.column(c);
            const std::int64_t from = c - first;
            const std::int64_t length = span - from;
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

} // namespace

void assemble(const Patches& patches, const Machine& machine, EnvelopeMatrix& matrix) {
    for_column_blocks(patches, matrix.order(), column_block, machine.threads,
                      [&](std::int64_t begin, std::int64_t end, PatchRange range) {
                          matrix.clear(begin, end);
                          PatchTerms terms;
                          for (std::int64_t p = range.begin; p < range.end; ++p) {
                              const auto frames = patches.of(p);
                              if (frames.front() >= end || frames.back() <= begin)
                                  continue;
                              terms.set(patches, p);
                              run_simd(machine.simd, AddPatch{matrix, begin, end, terms});
                          }
                      });
}

} // namespace stltsa::ltsa
