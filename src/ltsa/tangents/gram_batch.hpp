// SPDX-License-Identifier: BSD-3-Clause
// Principal directions of several small neighborhoods at once, one in each lane of a pack.
#pragma once

#include <cstdint>
#include <span>

#include "ltsa/tangents/eigen_batch.hpp"

namespace stltsa::ltsa {

/// Finds the leading eigenvectors of correlation matrices, which are the directions themselves.
class GramBatch {
  public:
    /// Matrices of larger neighborhoods, one a lane, no longer fit into the cache.
    static constexpr std::int64_t largest_size = 128;

    /// For neighborhoods of `size` frames, `count` directions.
    GramBatch(std::int64_t size, std::int64_t count, Simd simd);

    std::int64_t lanes() const { return eigen_.lanes(); }
    /// Takes the squared distance of frames a < b of a lane's neighborhood.
    void set_distance(std::int64_t lane, std::int64_t a, std::int64_t b, double distance) {
        eigen_.matrix(lane, a, b) = distance;
    }
    /// Every lane must have its distances; they are destroyed.
    void solve();

    bool found(std::int64_t lane) const { return eigen_.found(lane); }
    /// Eigenvalue l of the correlation matrix, descending.
    double value(std::int64_t lane, std::int64_t l) const { return eigen_.value(lane, l); }
    /// Writes the eigenvectors of a lane, whatever its members: `count` rows of `size` entries.
    void directions(std::int64_t lane, std::span<const std::int32_t> members, double* out) const;

  private:
    std::int64_t size_, count_;
    EigenBatch eigen_;
};

} // namespace stltsa::ltsa
