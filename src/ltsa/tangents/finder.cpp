// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangents/finder.hpp"

#include <algorithm>

#include "ltsa/neighbors/band_distances.hpp"
#include "ltsa/neighbors/neighborhood_distances.hpp"

namespace stltsa::ltsa {

TangentFinder::TangentFinder(ConstMatrixView x, const Neighborhoods& neighborhoods,
                             std::int64_t computed, Simd simd, Matrix& values, Tangents& tangents)
    : neighborhoods_(neighborhoods), computed_(computed), values_(values), tangents_(tangents),
      pca_(x, neighborhoods.size, computed, simd) {
    if (takes_distances(neighborhoods.size, x.cols))
        gram_.emplace(neighborhoods.size, computed, simd);
    else if (CovarianceBatch::worth_while(neighborhoods.size, x.cols))
        covariance_.emplace(x, neighborhoods.size, computed, simd);
}

template <class Distance>
void TangentFinder::find(std::int64_t first, std::int64_t last, Distance& distance) {
    if (gram_)
        for (std::int64_t i = first; i < last; i += gram_->lanes())
            find_by_distances(i, std::min(i + gram_->lanes(), last), distance);
    else if (covariance_)
        for (std::int64_t i = first; i < last; i += CovarianceBatch::group)
            find_by_covariances(i, std::min(i + CovarianceBatch::group, last));
    else
        for (std::int64_t i = first; i < last; ++i)
            find_alone(i);
}

template void TangentFinder::find(std::int64_t, std::int64_t, const BandDistances&);
template void TangentFinder::find(std::int64_t, std::int64_t, NeighborhoodDistances&);

template <class Distance>
void TangentFinder::find_by_distances(std::int64_t first, std::int64_t last, Distance& distance) {
    for (std::int64_t lane = 0; lane < gram_->lanes(); ++lane) {
        // Unused lanes repeat the last frame.
        const auto among = distance.among(neighborhoods_.of(std::min(first + lane, last - 1)));
        for (std::int64_t b = 1; b < neighborhoods_.size; ++b)
            for (std::int64_t a = 0; a < b; ++a)
                gram_->set_distance(lane, a, b, among(a, b));
    }
    gram_->solve();
    for (std::int64_t i = first; i < last; ++i)
        take(*gram_, i - first, i);
}

void TangentFinder::find_by_covariances(std::int64_t first, std::int64_t last) {
    const std::int64_t lanes = covariance_->lanes();
    covariance_->begin_group(neighborhoods_, first, last);
    for (std::int64_t begin = first; begin < last; begin += lanes) {
        for (std::int64_t lane = 0; lane < lanes; ++lane)
            covariance_->set_members(lane, neighborhoods_.of(std::min(begin + lane, last - 1)));
        covariance_->solve();
        for (std::int64_t i = begin; i < std::min(begin + lanes, last); ++i)
            take(*covariance_, i - begin, i);
    }
}

/// Table 1, step 3: writes the directions that a lane has found for frame i.
template <class Batch>
void TangentFinder::take(Batch& batch, std::int64_t lane, std::int64_t i) {
    if (!batch.found(lane)) {
        find_alone(i);
        return;
    }
    double* g = tangents_.direction(i, 0);
    batch.directions(lane, neighborhoods_.of(i), g);
    for (std::int64_t l = 0; l < computed_; ++l) {
        values_(i, l) = batch.value(lane, l);
        make_tangent(g, l, neighborhoods_.size, tangents_.direction(i, l));
    }
}

void TangentFinder::find_alone(std::int64_t i) {
    pca_.compute(neighborhoods_.of(i));
    for (std::int64_t l = 0; l < computed_; ++l) {
        values_(i, l) = pca_.value(l);
        pca_.direction(l, tangents_.direction(i, l), tangents_.direction(i, 0));
    }
}

} // namespace stltsa::ltsa
