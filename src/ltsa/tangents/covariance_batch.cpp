// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangents/covariance_batch.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <cblas.h>

#include "ltsa/tangents/centered.hpp"

namespace stltsa::ltsa {
namespace {

/// Terms added to the matrix at a time, because it is larger than the first-level cache.
constexpr std::int64_t term_group = 8;

/// Additional columns of the block: more columns converge in fewer, longer steps.
constexpr std::int64_t covariance_guards = 4;

/// Covariance matrices times k, as the products of the shared members plus those of the terms (the
/// other members) minus S S^T / k, with S the sum of the terms.
struct CovarianceKernel {
    BlockIteration iteration;
    ConstMatrixView shared;   ///< upper triangle
    const double* terms_data; ///< whole groups of terms
    std::int64_t terms;
    double root_of_size;

    template <int W>
    STLTSA_INLINE void run() const {
        using P = Pack<W>;
        subtract_mean<P>();
        for (std::int64_t t = 0; t < terms; t += term_group)
            add_terms<P>(t);
        iteration.iterate<P>();
    }

    template <class P>
    STLTSA_INLINE const P* term(std::int64_t t) const {
        return reinterpret_cast<const P*>(terms_data) + t * iteration.size;
    }

    template <class P>
    STLTSA_INLINE void subtract_mean() const {
        P* matrix = reinterpret_cast<P*>(iteration.matrix_data);
        P* mean = reinterpret_cast<P*>(iteration.product_data);
        for (std::int64_t c = 0; c < iteration.size; ++c) {
            mean[c] = P{};
            for (std::int64_t t = 0; t < terms; ++t)
                mean[c] += term<P>(t)[c];
            mean[c] /= root_of_size;
        }
        for (std::int64_t a = 0; a < iteration.size; ++a)
            for (std::int64_t b = a; b < iteration.size; ++b)
                matrix[a * iteration.rows + b] = shared(a, b) - mean[a] * mean[b];
    }

    template <class P>
    STLTSA_INLINE void add_terms(std::int64_t first) const {
        P* matrix = reinterpret_cast<P*>(iteration.matrix_data);
        const std::int64_t rows = iteration.rows;
        for (std::int64_t a = 0; a < iteration.size; ++a) {
            P factor[term_group];
            for (std::int64_t t = 0; t < term_group; ++t)
                factor[t] = term<P>(first + t)[a];
            for (std::int64_t b = a; b < iteration.size; ++b) {
                P entry = matrix[a * rows + b];
                for (std::int64_t t = 0; t < term_group; ++t)
                    entry += factor[t] * term<P>(first + t)[b];
                matrix[a * rows + b] = matrix[b * rows + a] = entry;
            }
        }
    }
};

} // namespace

CovarianceBatch::CovarianceBatch(ConstMatrixView x, std::int64_t size, std::int64_t count,
                                 Simd simd)
    : x_(x), features_(x.cols), size_(size), count_(count),
      eigen_({features_, count, count + covariance_guards}, simd),
      shared_products_(features_, features_), offset_(static_cast<std::size_t>(features_)),
      vector_(static_cast<std::size_t>(features_)), centered_(size, features_),
      terms_(checked_size(rounded_up(size, term_group) * lanes(), features_)),
      terms_in_use_(term_group) {}

void CovarianceBatch::begin_group(const Neighborhoods& neighborhoods, std::int64_t first,
                                  std::int64_t last) {
    shared_.assign(neighborhoods.of(first).begin(), neighborhoods.of(first).end());
    for (std::int64_t i = first + 1; i < last; ++i) {
        own_.clear();
        std::ranges::set_intersection(shared_, neighborhoods.of(i), std::back_inserter(own_));
        shared_.swap(own_);
    }
    if (shared_.empty()) {
        std::fill_n(shared_products_.data(), features_ * features_, 0.0);
        return;
    }
    center(shared_);
    const auto order = static_cast<int>(features_);
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, order, static_cast<int>(shared_.size()),
                1.0, centered_.data(), order, 0.0, shared_products_.data(), order);
}

/// Writes the members minus their mean, which becomes the origin.
void CovarianceBatch::center(std::span<const std::int32_t> members) {
    origin_ = x_.row(members[members.size() / 2]);
    write_differences(x_, members, origin_, centered_.data());
    const auto rows = centered_.view().block(0, static_cast<std::int64_t>(members.size()));
    mean_of(rows, offset_.data());
    subtract(offset_.data(), rows);
}

void CovarianceBatch::set_members(std::int64_t lane, std::span<const std::int32_t> members) {
    own_.clear();
    std::ranges::set_difference(members, shared_, std::back_inserter(own_));
    if (shared_.empty()) {
        center(own_);
    } else {
        write_differences(x_, own_, origin_, centered_.data());
        subtract(offset_.data(), centered_.view().block(0, static_cast<std::int64_t>(own_.size())));
    }
    const auto own = static_cast<std::int64_t>(own_.size());
    for (std::int64_t i = 0; i < own * features_; ++i)
        terms_[static_cast<std::size_t>(i * lanes() + lane)] = centered_.data()[i];
    terms_in_use_ = std::max(terms_in_use_, rounded_up(own, term_group));
}

void CovarianceBatch::solve() {
    run_simd(eigen_.simd(),
             CovarianceKernel{eigen_.iteration(), shared_products_.view(), terms_.data(),
                              terms_in_use_, std::sqrt(static_cast<double>(size_))});
    std::fill_n(terms_.begin(), terms_in_use_ * features_ * lanes(), 0.0);
    terms_in_use_ = term_group;
}

void CovarianceBatch::directions(std::int64_t lane, std::span<const std::int32_t> members,
                                 double* out) {
    write_differences(x_, members, x_.row(members[members.size() / 2]), centered_.data());
    const auto order = static_cast<int>(features_);
    for (std::int64_t l = 0; l < count_; ++l) {
        for (std::int64_t c = 0; c < features_; ++c)
            vector_[static_cast<std::size_t>(c)] = eigen_.vector(lane, l, c);
        cblas_dgemv(CblasColMajor, CblasTrans, order, static_cast<int>(size_), 1.0,
                    centered_.data(), order, vector_.data(), 1, 0.0, out + l * size_, 1);
    }
}

} // namespace stltsa::ltsa
