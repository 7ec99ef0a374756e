// SPDX-License-Identifier: BSD-3-Clause
// The alignment matrix B in the differences z_c = x_{c+1} - x_c: with x = S z, B' = S^T B S has no
// null vector, and the pseudo-inverse is B^+ = P S (B')^-1 S^T P (P centers).
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "local.hpp"

namespace reference {

/// A symmetric positive definite band matrix by its lower half; after factor(), L.
template <class T>
class Band {
  public:
    Band(std::size_t rows, std::size_t half_width) : below_(rows, half_width + 1) {}

    std::size_t rows() const { return below_.rows; }
    std::size_t half_width() const { return below_.cols - 1; }
    /// Entry (row, col), col <= row <= col + half_width.
    T& at(std::size_t row, std::size_t col) { return below_(col, row - col); }
    const T& at(std::size_t row, std::size_t col) const { return below_(col, row - col); }

    /// Cholesky, right-looking, in place.
    void factor() {
        for (std::size_t c = 0; c < rows(); ++c) {
            if (!(at(c, c) > T(0)))
                throw std::runtime_error("disconnected between frames " + std::to_string(c) +
                                         " and " + std::to_string(c + 1));
            const std::size_t end = std::min(rows(), c + half_width() + 1);
            at(c, c) = sqrt(at(c, c));
            for (std::size_t r = c + 1; r < end; ++r)
                at(r, c) /= at(c, c);
            for (std::size_t j = c + 1; j < end; ++j)
                for (std::size_t r = j; r < end; ++r)
                    at(r, j) -= at(r, c) * at(j, c);
        }
    }

    /// z becomes (L L^T)^-1 z.
    void solve(std::vector<T>& z) const {
        for (std::size_t c = 0; c < rows(); ++c) {
            z[c] /= at(c, c);
            for (std::size_t r = c + 1; r < std::min(rows(), c + half_width() + 1); ++r)
                z[r] -= at(r, c) * z[c];
        }
        for (std::size_t c = rows(); c-- > 0;) {
            for (std::size_t r = c + 1; r < std::min(rows(), c + half_width() + 1); ++r)
                z[c] -= at(r, c) * z[r];
            z[c] /= at(c, c);
        }
    }

  private:
    Table<T> below_;
};

/// Adds one neighborhood p_0 < .. < p_{k-1} with its first d tangents:
/// B'(c, c') += a(max) (k - a(min)) / k - sum_l h_l(c) h_l(c'), where a(c) = #{j: p_j > c} and
/// h_l(c) = sum of g_l(j) over p_j > c.
template <class T>
void add_neighborhood(Band<T>& matrix, const Tangents<T>& tangents, std::size_t frame,
                      const std::size_t* p, std::size_t k, std::size_t d) {
    const std::size_t first = p[0];
    const std::size_t span = p[k - 1] - first;
    std::vector<double> a(span, 0);
    Table<T> h(d, span);
    for (std::size_t j = 0; j < k; ++j)
        for (std::size_t c = 0; c < p[j] - first; ++c) {
            a[c] += 1;
            for (std::size_t l = 0; l < d; ++l)
                h(l, c) += tangents.of(frame, l)[j];
        }
    const double count = static_cast<double>(k);
    for (std::size_t c = 0; c < span; ++c)
        for (std::size_t r = c; r < span; ++r) {
            T sum = T(a[r] * (count - a[c])) / T(count);
            for (std::size_t l = 0; l < d; ++l)
                sum -= h(l, r) * h(l, c);
            matrix.at(first + r, first + c) += sum;
        }
}

template <class T>
Band<T> differenced_alignment(const Neighbors& neighbors, const Tangents<T>& tangents,
                              std::size_t d) {
    const std::size_t k = neighbors.cols;
    std::size_t widest = 1;
    for (std::size_t i = 0; i < neighbors.rows; ++i)
        widest = std::max(widest, neighbors(i, k - 1) - neighbors(i, 0));
    Band<T> matrix(neighbors.rows - 1, widest - 1);
    for (std::size_t i = 0; i < neighbors.rows; ++i)
        add_neighborhood(matrix, tangents, i, neighbors.row(i), k, d);
    return matrix;
}

/// x becomes B^+ x, for the factored B'.
template <class T>
void apply_pseudo_inverse(const Band<T>& factor, std::vector<T>& x) {
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
