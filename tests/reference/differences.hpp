// SPDX-License-Identifier: BSD-3-Clause
// The alignment matrix B in the differences z_c = x_{c+1} - x_c: with x = S z, B' = S^T B S has no
// null vector, and the pseudo-inverse is B^+ = P S (B')^-1 S^T P, where P centers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "local.hpp"
#include "vectors.hpp"

namespace reference {

/// The lower half of a symmetric positive definite band matrix; after factor(), its factor L.
template <class T>
class Band {
  public:
    Band(std::size_t rows, std::size_t half_width) : below_(rows, half_width + 1) {}

    std::size_t rows() const { return below_.rows; }
    std::size_t half_width() const { return below_.cols - 1; }
    /// Entry (row, col), col <= row <= col + half_width.
    T& at(std::size_t row, std::size_t col) { return below_(col, row - col); }
    const T& at(std::size_t row, std::size_t col) const { return below_(col, row - col); }

    /// Right-looking Cholesky factorization, in place.
    void factor() {
        for (std::size_t c = 0; c < rows(); ++c) {
            if (!(at(c, c) > T(0)))
                throw std::runtime_error("disconnected between frames " + std::to_string(c) +
                                         " and " + std::to_string(c + 1));
            const std::size_t end = c + below(c) + 1;
            at(c, c) = sqrt(at(c, c));
            const T inverse = T(1) / at(c, c);
            for (std::size_t r = c + 1; r < end; ++r)
                at(r, c) *= inverse;
            for (std::size_t j = c + 1; j < end; ++j)
                add_scaled<T>(&at(j, j), -at(j, c), &at(j, c), end - j);
        }
    }

    /// Replaces z by (L L^T)^-1 z.
    void solve(std::vector<T>& z) const {
        for (std::size_t c = 0; c < rows(); ++c) {
            z[c] /= at(c, c);
            add_scaled<T>(z.data() + c + 1, -z[c], &at(c, c) + 1, below(c));
        }
        for (std::size_t c = rows(); c-- > 0;) {
            z[c] -= inner<T>(&at(c, c) + 1, z.data() + c + 1, below(c));
            z[c] /= at(c, c);
        }
    }

  private:
    /// Number of entries of column c below the diagonal.
    std::size_t below(std::size_t c) const { return std::min(rows() - 1 - c, half_width()); }

    Table<T> below_;
};

/// For a neighborhood p_0 < .. < p_{k-1} and the differences c = p_0 .. p_{k-1} - 1: a(c) = #{j:
/// p_j > c}, and h_l(c) is the sum of g_l(j) over p_j > c.
template <class T>
struct SuffixSums {
    std::size_t span;
    std::vector<T> a;
    Table<T> h;

    SuffixSums(const Tangents<T>& tangents, std::size_t frame, const std::size_t* p, std::size_t k,
               std::size_t d)
        : span(p[k - 1] - p[0]), a(span), h(d, span) {
        std::vector<T> sums(d, T(0));
        for (std::size_t j = k - 1; j > 0; --j) {
            for (std::size_t l = 0; l < d; ++l)
                sums[l] += tangents.of(frame, l)[j];
            for (std::size_t c = p[j - 1] - p[0]; c < p[j] - p[0]; ++c) {
                a[c] = T(static_cast<double>(k - j));
                for (std::size_t l = 0; l < d; ++l)
                    h(l, c) = sums[l];
            }
        }
    }
};

/// Adds one neighborhood with its first d tangents:
/// B'(c, c') += a(max) (k - a(min)) / k - sum_l h_l(c) h_l(c').
template <class T>
void add_neighborhood(Band<T>& matrix, const SuffixSums<T>& sums, std::size_t first,
                      std::size_t k) {
    const T count(static_cast<double>(k));
    for (std::size_t c = 0; c < sums.span; ++c) {
        T* column = &matrix.at(first + c, first + c);
        const std::size_t length = sums.span - c;
        add_scaled<T>(column, (count - sums.a[c]) / count, sums.a.data() + c, length);
        for (std::size_t l = 0; l < sums.h.rows; ++l)
            add_scaled<T>(column, -sums.h(l, c), sums.h.row(l) + c, length);
    }
}

/// Number of differences spanned by the widest neighborhood.
inline std::size_t widest_span(const Neighbors& neighbors) {
    std::size_t widest = 1;
    for (std::size_t i = 0; i < neighbors.rows; ++i)
        widest = std::max(widest, neighbors(i, neighbors.cols - 1) - neighbors(i, 0));
    return widest;
}

template <class T>
Band<T> differenced_alignment(const Neighbors& neighbors, const Tangents<T>& tangents,
                              std::size_t d) {
    const std::size_t k = neighbors.cols;
    Band<T> matrix(neighbors.rows - 1, widest_span(neighbors) - 1);
    for (std::size_t i = 0; i < neighbors.rows; ++i) {
        const std::size_t* p = neighbors.row(i);
        add_neighborhood(matrix, SuffixSums<T>(tangents, i, p, k, d), p[0], k);
    }
    return matrix;
}

/// Replaces x by B^+ x, given the factored B'.
template <class Factor, class T>
void apply_pseudo_inverse(const Factor& factor, std::vector<T>& x) {
    const std::size_t n = x.size();
    const auto center = [&x, n] {
        T mean(0);
        for (const T& value : x)
            mean += value;
        mean /= T(static_cast<double>(n));
        for (T& value : x)
            value -= mean;
    };
    center();
    std::vector<T> z(n - 1);
    T sum(0);
    for (std::size_t c = n - 1; c > 0; --c)
        z[c - 1] = sum += x[c];
    factor.solve(z);
    x[0] = T(0);
    for (std::size_t c = 1; c < n; ++c)
        x[c] = x[c - 1] + z[c - 1];
    center();
}

} // namespace reference
