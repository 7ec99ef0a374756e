// SPDX-License-Identifier: BSD-3-Clause
// Principal directions of neighborhoods with more frames than features, several at once, one in
// each lane of a pack.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/tangents/eigen_batch.hpp"

namespace stltsa::ltsa {

/// Finds the leading eigenvectors of covariance matrices, over the features. Neighborhoods of
/// successive frames have most of their members in common: what these add to the matrices is
/// computed once for a group of frames.
class CovarianceBatch {
  public:
    /// Frames of a group: a multiple of the lanes of every machine, so that results do not depend
    /// on it.
    static constexpr std::int64_t group = 8;

    /// Whether matrices of this many features are small enough beside neighborhoods of this size.
    static bool worth_while(std::int64_t size, std::int64_t features) {
        return features <= std::min<std::int64_t>(2 * size, 512);
    }

    /// For neighborhoods of `size` frames, `count` directions.
    CovarianceBatch(ConstMatrixView x, std::int64_t size, std::int64_t count, Simd simd);

    std::int64_t lanes() const { return eigen_.lanes(); }
    /// The neighborhoods of frames [first, last) come next.
    void begin_group(const Neighborhoods& neighborhoods, std::int64_t first, std::int64_t last);
    void set_members(std::int64_t lane, std::span<const std::int32_t> members);
    /// Every lane must have its members.
    void solve();

    bool found(std::int64_t lane) const { return eigen_.found(lane); }
    /// Eigenvalue l of the covariance matrix times the size, descending.
    double value(std::int64_t lane, std::int64_t l) const { return eigen_.value(lane, l); }
    /// Writes what the members of a lane have in each direction: `count` rows of `size` entries.
    void directions(std::int64_t lane, std::span<const std::int32_t> members, double* out);

  private:
    void center(std::span<const std::int32_t> members);

    ConstMatrixView x_;
    std::int64_t features_, size_, count_;
    EigenBatch eigen_;
    std::vector<std::int32_t> shared_; ///< members that all neighborhoods of the group have
    std::vector<std::int32_t> own_;    ///< the others of one neighborhood
    Matrix shared_products_;           ///< of the features, summed over the shared members
    const double* origin_ = nullptr;   ///< subtracted from frames, and then the offset
    AlignedVector<double> offset_;
    AlignedVector<double> vector_; ///< of one direction
    Matrix centered_;              ///< frames of one neighborhood about the origin
    AlignedVector<double> terms_;  ///< own members of all lanes
    std::int64_t terms_in_use_;
};

} // namespace stltsa::ltsa
