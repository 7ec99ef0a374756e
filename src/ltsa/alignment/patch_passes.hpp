// SPDX-License-Identifier: BSD-3-Clause
// Passes over all patches, for panels of vectors. Access converts between the unknowns of an
// alignment and the values at a patch's frames:
//     gather<P>(frames, k, unknowns, column, values)
//     scatter<P>(frames, k, values, unknowns, column)      the transpose of gather
#pragma once

#include <algorithm>
#include <cstdint>

#include "linalg/panel.hpp"
#include "ltsa/alignment/alignment.hpp"
#include "ltsa/alignment/patches.hpp"

namespace stltsa::ltsa {

/// The sum of term(0) .. term(count - 1), as four independent sums.
template <class P, class Term>
STLTSA_INLINE P sum_of_terms(std::int64_t count, const Term& term) {
    P sums[4] = {};
    std::int64_t j = 0;
    for (; j + 4 <= count; j += 4)
        for (std::int64_t i = 0; i < 4; ++i)
            sums[i] += term(j + i);
    for (; j < count; ++j)
        sums[0] += term(j);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// v := (I - e e^T/k - G G^T) v for `count` directions G.
template <std::int64_t count, class P>
STLTSA_INLINE void project_on(const double* g, std::int64_t k, P* v) {
    P sums[2][1 + count] = {}; // of even and odd entries, which are independent
    const auto add = [&](std::int64_t parity, std::int64_t j) STLTSA_INLINE_LAMBDA {
        sums[parity][0] += v[j];
        for (std::int64_t l = 0; l < count; ++l)
            sums[parity][1 + l] += g[l * k + j] * v[j];
    };
    std::int64_t j = 0;
    for (; j + 2 <= k; j += 2) {
        add(0, j);
        add(1, j + 1);
    }
    if (j < k)
        add(0, j);
    const P mean = (sums[0][0] + sums[1][0]) / static_cast<double>(k);
    P overlaps[count];
    for (std::int64_t l = 0; l < count; ++l)
        overlaps[l] = sums[0][1 + l] + sums[1][1 + l];
    for (j = 0; j < k; ++j) {
        P projection = mean;
        for (std::int64_t l = 0; l < count; ++l)
            projection += overlaps[l] * g[l * k + j];
        v[j] -= projection;
    }
}

/// The same for any number of directions, at most three at a time.
template <class P>
STLTSA_INLINE void project_once(const double* g, std::int64_t k, std::int64_t dimension, P* v) {
    for (; dimension > 3; dimension -= 2, g += 2 * k)
        project_on<2>(g, k, v);
    if (dimension == 3)
        project_on<3>(g, k, v);
    else if (dimension == 2)
        project_on<2>(g, k, v);
    else
        project_on<1>(g, k, v);
}

/// Gathers the values at a patch's frames and projects them twice: g is orthonormal only up to
/// rounding, and the remainder of one projection would limit the accuracy of corrections (by a
/// factor of 10 on motion, 1000 on smooth curves; see measure/accuracy).
template <class Access, class P>
STLTSA_INLINE void project_patch(const Patches& patches, std::int64_t patch,
                                 ConstMatrixView unknowns, std::int64_t column, P* values) {
    const std::int64_t k = patches.size();
    Access::gather(patches.of(patch).data(), k, unknowns, column, values);
    const double* g = patches.direction(patch, 0);
    project_once(g, k, patches.dimension(), values);
    project_once(g, k, patches.dimension(), values);
}

/// out += S^T B x for the x of the unknowns, and form += x^T B x as a sum of squares over patches,
/// so that small eigenvalues keep their digits.
template <class Access>
struct ProductPass {
    const Patches& patches;
    std::int64_t begin, end; ///< patches
    ConstMatrixView in;
    MatrixView out;
    MatrixView form;   ///< one row per vector of the panel
    double* workspace; ///< k rows of a panel, then k packs

    template <int W>
    STLTSA_INLINE void run() const {
        const std::int64_t k = patches.size();
        const MatrixView values{workspace, k, in.cols, in.cols};
        Pack<W>* projected = reinterpret_cast<Pack<W>*>(workspace + k * in.cols);
        for (std::int64_t p = begin; p < end; ++p) {
            for (std::int64_t c = 0; c < in.cols; c += W) {
                project_patch<Access>(patches, p, in, c, projected);
                Access::scatter(patches.of(p).data(), k, projected, out, c);
                for (std::int64_t j = 0; j < k; ++j)
                    pack_at<Pack<W>>(values.row(j) + c) = projected[j];
            }
            for (std::int64_t i = 0; i < form.rows; ++i)
                for (std::int64_t c = 0; c < in.cols; c += W)
                    pack_at<Pack<W>>(form.row(i) + c) +=
                        sum_of_terms<Pack<W>>(k, [&](std::int64_t j) STLTSA_INLINE_LAMBDA {
                            return values(j, i) * pack_at<Pack<W>>(values.row(j) + c);
                        });
        }
    }
};

/// Blocks of patches. Blocks of one parity share no frame, so several threads may add to the frames
/// at once, first for one parity and then for the other. If that is impossible, because
/// neighborhoods have distant frames, there is one block.
class PatchBlocks {
  public:
    explicit PatchBlocks(const Patches& patches);

    std::int64_t count() const { return count_; }
    std::int64_t begin(std::int64_t block) const { return block * size_; }
    std::int64_t end(std::int64_t block) const { return std::min(begin(block) + size_, patches_); }

  private:
    std::int64_t patches_, size_, count_;
};

/// An alignment that is applied patch by patch, with Access.
template <class Access>
class PatchwiseAlignment : public Alignment {
  public:
    PatchwiseAlignment(const Patches& patches, const Machine& machine)
        : Alignment(patches, machine), blocks_(patches) {}

    Matrix apply(ConstMatrixView in, MatrixView out, std::int64_t count) const override {
        clear(out, machine_);
        Matrix forms(blocks_.count() * count, in.cols);
        for (const std::int64_t parity : {0, 1})
            parallel_blocks((blocks_.count() + 1 - parity) / 2, threads(), [&](std::int64_t half) {
                const std::int64_t b = 2 * half + parity;
                AlignedVector<double> workspace(checked_size(patches_->size(), 2 * in.cols));
                run_simd(machine_.simd,
                         ProductPass<Access>{*patches_, blocks_.begin(b), blocks_.end(b), in, out,
                                             forms.view().block(b * count, count),
                                             workspace.data()});
            });
        Matrix form(count, in.cols);
        for (std::int64_t row = 0; row < forms.rows(); ++row)
            for (std::int64_t c = 0; c < in.cols; ++c)
                form(row % count, c) += forms(row, c);
        return form;
    }

  private:
    int threads() const { return threads_for(patches_->frames(), 4096, machine_); }

    PatchBlocks blocks_;
};

} // namespace stltsa::ltsa
