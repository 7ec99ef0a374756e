// SPDX-License-Identifier: BSD-3-Clause
// The tangents of some frames' neighborhoods: several at a time by block iteration, and by LAPACK
// one at a time if that does not find them or the neighborhoods are too large for it.
#pragma once

#include <cstdint>
#include <optional>

#include "linalg/matrix.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/tangents/covariance_batch.hpp"
#include "ltsa/tangents/gram_batch.hpp"
#include "ltsa/tangents/local_pca.hpp"
#include "ltsa/tangents/tangents.hpp"

namespace stltsa::ltsa {

class TangentFinder {
  public:
    /// Writes to `values` (frames x computed) and to `tangents`.
    TangentFinder(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t computed,
                  Simd simd, Matrix& values, Tangents& tangents);

    /// Whether it needs the distances within all neighborhoods.
    static bool takes_distances(std::int64_t size, std::int64_t features) {
        return size <= std::min(features, GramBatch::largest_size);
    }

    /// distance.among(members): squared distances of these, as BandDistances and
    /// NeighborhoodDistances have them.
    template <class Distance>
    void find(std::int64_t first, std::int64_t last, Distance& distance);

  private:
    template <class Distance>
    void find_by_distances(std::int64_t first, std::int64_t last, Distance& distance);
    void find_by_covariances(std::int64_t first, std::int64_t last);
    void find_alone(std::int64_t i);
    template <class Batch>
    void take(Batch& batch, std::int64_t lane, std::int64_t i);

    const Neighborhoods& neighborhoods_;
    std::int64_t computed_;
    Matrix& values_;
    Tangents& tangents_;
    LocalPca pca_;
    std::optional<GramBatch> gram_;
    std::optional<CovarianceBatch> covariance_;
};

} // namespace stltsa::ltsa
