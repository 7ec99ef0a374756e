// SPDX-License-Identifier: BSD-3-Clause
// Principal directions of one neighborhood at a time, from its frames themselves: slow, and exact
// where a wanted direction is small against the first. A product of frames, as in LocalPca, keeps
// of it only what is above the rounding of the first one's square.
#pragma once

#include <cstdint>
#include <span>

#include "linalg/graded_svd.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::ltsa {

class LocalSvd {
  public:
    /// For neighborhoods of `size` frames, `count` directions (at most min(size, features)).
    LocalSvd(ConstMatrixView x, std::int64_t size, std::int64_t count)
        : x_(x), size_(size), svd_(size, x.cols, count) {}

    /// False where they were not found.
    bool compute(std::span<const std::int32_t> neighborhood);

    /// Eigenvalue l of the correlation matrix, descending from l = 0.
    double value(std::int64_t l) const { return svd_.value(l) * svd_.value(l); }
    /// As LocalPca::direction().
    void direction(std::int64_t l, double* out, const double* before) const;

  private:
    ConstMatrixView x_;
    std::int64_t size_;
    GradedSvd svd_;
};

} // namespace stltsa::ltsa
