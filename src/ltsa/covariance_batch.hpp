// SPDX-License-Identifier: BSD-3-Clause
// Principal directions, over the features, of neighborhoods that change little from one to the
// next: one sequence of them in each lane of a pack.
#pragma once

#include <cstdint>
#include <vector>

#include "ltsa/eigen_batch.hpp"

namespace stltsa::ltsa {

/// A covariance matrix is brought up to date by the frames that come and go, and its eigenvectors
/// by block iteration from those of the neighborhood before. Rounding adds up from one to the next:
/// sequences are to be short.
class CovarianceBatch {
  public:
    /// For neighborhoods of `size` frames, `count` directions.
    CovarianceBatch(std::int64_t features, std::int64_t size, std::int64_t count, Simd simd);

    std::int64_t lanes() const { return eigen_.lanes(); }
    /// Forgets all neighborhoods and what was found.
    void clear();
    /// Begins a lane's sequence with an empty neighborhood. The origin is subtracted from its
    /// frames: near their mean, no digits are lost.
    void restart(std::int64_t lane, const double* origin);
    /// A frame that has come into a lane's neighborhood (sign 1) or left it (sign -1).
    void change(std::int64_t lane, const double* frame, double sign);
    /// Takes in the changes.
    void solve();

    bool found(std::int64_t lane) const { return eigen_.found(lane); }
    /// Of the scatter matrix.
    double trace(std::int64_t lane) const;
    /// Eigenvalue l of the scatter matrix (the covariance matrix times the size), descending.
    double value(std::int64_t lane, std::int64_t l) const { return eigen_.value(lane, l); }
    /// Entry of its eigenvector.
    double vector(std::int64_t lane, std::int64_t l, std::int64_t feature) const {
        return eigen_.vector(lane, l, feature);
    }

  private:
    double* term(std::int64_t t) { return terms_.data() + t * (features_ + 1) * lanes(); }
    void add_room();

    std::int64_t features_;
    double root_of_size_;
    EigenBatch eigen_;
    AlignedVector<double> start_; ///< columns of the block
    AlignedVector<double> origin_, sum_;
    AlignedVector<double> terms_;    ///< of each the signs, then the entries
    std::vector<std::int64_t> used_; ///< terms of each lane
    std::int64_t terms_in_use_ = 0;  ///< the most of any lane
};

} // namespace stltsa::ltsa
