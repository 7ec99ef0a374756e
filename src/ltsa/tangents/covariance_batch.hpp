// SPDX-License-Identifier: BSD-3-Clause
// Table 1, step 2 for neighborhoods with more frames than features: several at once, one per lane
// of a pack.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/tangents/eigen_batch.hpp"

namespace stltsa::ltsa {

/// Finds the leading eigenvectors of covariance matrices of the features. Neighborhoods of
/// successive frames share most of their members, whose contribution is computed once for a group
/// of frames.
class CovarianceBatch {
  public:
    /// Frames of a group: a multiple of the lanes of every machine, so that results do not depend
    /// on the machine.
    static constexpr std::int64_t group = 8;

    /// Whether matrices of this many features are small enough for neighborhoods of this size.
    static bool worth_while(std::int64_t size, std::int64_t features) {
        return features <= std::min<std::int64_t>(2 * size, 512);
    }

    /// For neighborhoods of `size` frames, `count` directions.
    CovarianceBatch(ConstMatrixView x, std::int64_t size, std::int64_t count, Simd simd);

    std::int64_t lanes() const { return eigen_.lanes(); }
    /// Prepares for the neighborhoods of frames [first, last).
    void begin_group(const Neighborhoods& neighborhoods, std::int64_t first, std::int64_t last);
    void set_members(std::int64_t lane, std::span<const std::int32_t> members);
    /// Needs the members of every lane.
    void solve();

    bool found(std::int64_t lane) const { return eigen_.found(lane); }
    /// Eigenvalue l of the covariance matrix times the size, descending.
    double value(std::int64_t lane, std::int64_t l) const { return eigen_.value(lane, l); }
    /// Writes the components of a lane's members along each direction: `count` rows of `size`
    /// entries.
    void directions(std::int64_t lane, std::span<const std::int32_t> members, double* out);

  private:
    void center(std::span<const std::int32_t> members);

    ConstMatrixView x_;
    std::int64_t features_, size_, count_;
    EigenBatch eigen_;
    std::vector<std::int32_t> shared_; ///< members common to all neighborhoods of the group
    std::vector<std::int32_t> own_;    ///< the other members of one neighborhood
    Matrix shared_products_;           ///< products of features, summed over the shared members
    const double* origin_ = nullptr;   ///< subtracted from frames before the offset
    AlignedVector<double> offset_;
    AlignedVector<double> vector_; ///< one direction
    Matrix centered_;              ///< frames of one neighborhood minus the origin
    AlignedVector<double> terms_;  ///< the other members of all lanes
    std::int64_t terms_in_use_;
};

} // namespace stltsa::ltsa
