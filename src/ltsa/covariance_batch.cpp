// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/covariance_batch.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace stltsa::ltsa {
namespace {

/// Terms that go into the matrix together: it is larger than the nearest cache.
constexpr std::int64_t term_group = 8;

/// Columns of the block beyond those that are wanted: the more, the sooner it converges, and the
/// longer a step takes.
constexpr std::int64_t guard_columns = 4;

/// Iterations from one Rayleigh-Ritz step to the next: few, for the block of the neighborhood
/// before is nearly right already.
constexpr std::int64_t ritz_interval = 3;

/// matrix += sum over terms of sign * term term^T, where a term is a frame about the origin. Then
/// the mean is taken out: with S the sum of all frames, S S^T / k leaves the matrix, and the one
/// of the neighborhood before comes back.
struct CovarianceKernel {
    BlockIteration iteration;
    const double* start;
    double* terms_data; ///< with room for two more, and zeros up to a whole group
    double* sum_data;
    std::int64_t terms;
    double root_of_size;

    template <int W>
    STLTSA_INLINE void run() const {
        using P = Pack<W>;
        add_means<P>();
        for (std::int64_t t = 0; t < terms + 2; t += term_group)
            add_terms<P>(t);
        fill_block<P>();
        iteration.iterate(iteration.trace<P>());
    }

    template <class P>
    STLTSA_INLINE P* term(std::int64_t t) const {
        return reinterpret_cast<P*>(terms_data) + t * (iteration.size + 1);
    }

    template <class P>
    STLTSA_INLINE void add_means() const {
        P* sum = reinterpret_cast<P*>(sum_data);
        P* before = term<P>(terms);
        P* after = term<P>(terms + 1);
        before[0] = P{} + 1.0;
        after[0] = P{} - 1.0;
        for (std::int64_t c = 0; c < iteration.size; ++c) {
            before[1 + c] = sum[c] / root_of_size;
            for (std::int64_t t = 0; t < terms; ++t)
                sum[c] += term<P>(t)[0] * term<P>(t)[1 + c];
            after[1 + c] = sum[c] / root_of_size;
        }
    }

    /// From what the neighborhood before ended with, where it did.
    template <class P>
    STLTSA_INLINE void fill_block() const {
        P* block = reinterpret_cast<P*>(iteration.block_data);
        const P* before = reinterpret_cast<const P*>(iteration.vectors_data);
        const P* values = reinterpret_cast<const P*>(iteration.values_data);
        const P usable = values[iteration.count] > 0 ? values[0] : P{};
        for (std::int64_t i = 0; i < iteration.rows * iteration.columns; ++i)
            block[i] = usable > 0 ? before[i] : P{} + start[i];
    }

    template <class P>
    STLTSA_INLINE void add_terms(std::int64_t first) const {
        P* matrix = reinterpret_cast<P*>(iteration.matrix_data);
        const std::int64_t rows = iteration.rows;
        for (std::int64_t a = 0; a < iteration.size; ++a) {
            P factor[term_group];
            for (std::int64_t t = 0; t < term_group; ++t)
                factor[t] = term<P>(first + t)[0] * term<P>(first + t)[1 + a];
            for (std::int64_t b = a; b < iteration.size; ++b) {
                P entry = matrix[a * rows + b];
                for (std::int64_t t = 0; t < term_group; ++t)
                    entry += factor[t] * term<P>(first + t)[1 + b];
                matrix[a * rows + b] = matrix[b * rows + a] = entry;
            }
        }
    }
};

} // namespace

CovarianceBatch::CovarianceBatch(std::int64_t features, std::int64_t size, std::int64_t count,
                                 Simd simd)
    : features_(features), root_of_size_(std::sqrt(static_cast<double>(size))),
      eigen_({features, count, count + guard_columns, true, ritz_interval}, simd),
      start_(checked_size(eigen_.rows(), eigen_.columns())),
      origin_(checked_size(features, lanes())), sum_(checked_size(features, lanes())),
      used_(static_cast<std::size_t>(lanes())) {
    add_room();
    // Columns beyond the number of features stay zero.
    Random random(1);
    for (std::int64_t l = 0; l < std::min(eigen_.columns(), features); ++l)
        for (std::int64_t a = 0; a < features; ++a)
            start_[static_cast<std::size_t>(l * eigen_.rows() + a)] = random.symmetric();
}

void CovarianceBatch::clear() {
    eigen_.clear();
    std::fill(sum_.begin(), sum_.end(), 0.0);
}

void CovarianceBatch::restart(std::int64_t lane, const double* origin) {
    for (std::int64_t a = 0; a < features_; ++a)
        for (std::int64_t b = 0; b < features_; ++b)
            eigen_.matrix(lane, a, b) = 0;
    for (std::int64_t c = 0; c < features_; ++c) {
        sum_[static_cast<std::size_t>(c * lanes() + lane)] = 0;
        origin_[static_cast<std::size_t>(c * lanes() + lane)] = origin[c];
    }
}

double CovarianceBatch::trace(std::int64_t lane) const {
    double sum = 0;
    for (std::int64_t a = 0; a < features_; ++a)
        sum += eigen_.matrix(lane, a, a);
    return sum;
}

void CovarianceBatch::change(std::int64_t lane, const double* frame, double sign) {
    const std::int64_t t = used_[static_cast<std::size_t>(lane)]++;
    terms_in_use_ = std::max(terms_in_use_, t + 1);
    add_room();
    double* entries = term(t) + lane;
    entries[0] = sign;
    for (std::int64_t c = 0; c < features_; ++c)
        entries[(1 + c) * lanes()] =
            frame[c] - origin_[static_cast<std::size_t>(c * lanes() + lane)];
}

/// For the terms in use, two more, and whole groups.
void CovarianceBatch::add_room() {
    const std::int64_t groups = (terms_in_use_ + 2 + term_group - 1) / term_group;
    const std::size_t needed = checked_size(groups * term_group, (features_ + 1) * lanes());
    if (terms_.size() < needed)
        terms_.resize(2 * needed);
}

void CovarianceBatch::solve() {
    run_simd(eigen_.simd(), CovarianceKernel{eigen_.iteration(), start_.data(), terms_.data(),
                                             sum_.data(), terms_in_use_, root_of_size_});
    std::fill(terms_.data(), term(terms_in_use_ + 2), 0.0);
    std::fill(used_.begin(), used_.end(), 0);
    terms_in_use_ = 0;
}

} // namespace stltsa::ltsa
