// SPDX-License-Identifier: BSD-3-Clause
// Table 1, step 2 for small neighborhoods: several at once, one per lane of a pack.
#pragma once

#include <cstdint>
#include <span>

#include "ltsa/tangents/eigen_batch.hpp"

namespace stltsa::ltsa {

/// Finds the leading eigenvectors of k x k correlation matrices, which are the directions g_l.
class GramBatch {
  public:
    /// Matrices of larger neighborhoods, one per lane, do not fit into the cache.
    static constexpr std::int64_t largest_size = 128;

    /// For neighborhoods of `size` frames, `count` directions.
    GramBatch(std::int64_t size, std::int64_t count, Simd simd);

    std::int64_t lanes() const { return eigen_.lanes(); }
    /// Sets the squared distance between members a < b of a lane's neighborhood.
    void set_distance(std::int64_t lane, std::int64_t a, std::int64_t b, double distance) {
        eigen_.matrix(lane, a, b) = distance;
    }
    /// Needs the distances of every lane and destroys them.
    void solve();

    bool found(std::int64_t lane) const { return eigen_.found(lane); }
    /// Eigenvalue l of the correlation matrix, descending.
    double value(std::int64_t lane, std::int64_t l) const { return eigen_.value(lane, l); }
    /// Writes the eigenvectors of a lane: `count` rows of `size` entries. Ignores the members.
    void directions(std::int64_t lane, std::span<const std::int32_t> members, double* out) const;

  private:
    std::int64_t size_, count_;
    EigenBatch eigen_;
};

} // namespace stltsa::ltsa
