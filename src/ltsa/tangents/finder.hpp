// SPDX-License-Identifier: BSD-3-Clause
// Finds the tangents of neighborhoods (Table 1, step 2; Table 1, step 3): several at a time by
// block iteration; one at a time by LAPACK if the iteration fails or the matrices are too large.
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

    /// Whether the distances within neighborhoods are used.
    static bool takes_distances(std::int64_t size, std::int64_t features) {
        return size <= std::min(features, GramBatch::largest_size);
    }

    /// For the frames [first, last). `distance`: a BandDistances or NeighborhoodDistances.
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
