// SPDX-License-Identifier: BSD-3-Clause
// Local tangents: the d leading eigenvectors of each neighborhood's centered Gram matrix
// (Zhang and Zha 2004; steps 2 and 3 of Table 1 in Li, Niu, Zhang, Hu 2012).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "jacobi.hpp"
#include "neighbors.hpp"

namespace reference {

/// Row i * d + l holds g_l of frame i, one entry per neighbor.
template <class T>
struct Tangents {
    std::size_t dimension = 0;
    Table<T> g;
    const T* of(std::size_t frame, std::size_t l) const { return g.row(frame * dimension + l); }
};

template <class T>
Table<T> centered_gram(const Frames& x, const std::size_t* neighbors, std::size_t k) {
    Table<T> z(k, x.cols);
    for (std::size_t c = 0; c < x.cols; ++c) {
        T mean(0);
        for (std::size_t j = 0; j < k; ++j)
            mean += T(x(neighbors[j], c));
        mean /= T(static_cast<double>(k));
        for (std::size_t j = 0; j < k; ++j)
            z(j, c) = T(x(neighbors[j], c)) - mean;
    }
    Table<T> gram(k, k);
    for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            T sum(0);
            for (std::size_t c = 0; c < x.cols; ++c)
                sum += z(i, c) * z(j, c);
            gram(i, j) = gram(j, i) = sum;
        }
    return gram;
}

template <class T>
Tangents<T> tangents(const Frames& x, const Neighbors& neighbors, std::size_t d) {
    const std::size_t k = neighbors.cols;
    Tangents<T> result{d, Table<T>(x.rows * d, k)};
    for (std::size_t i = 0; i < x.rows; ++i) {
        const auto eigen = symmetric_eigen(centered_gram<T>(x, neighbors.row(i), k));
        if (!(eigen.values[d - 1] > eigen.values[0] * T(1e-13)))
            throw std::runtime_error("the neighborhood of frame " + std::to_string(i) +
                                     " has fewer than d directions");
        for (std::size_t l = 0; l < d; ++l)
            std::copy_n(eigen.vectors.row(l), k, result.g.row(i * d + l));
    }
    return result;
}

} // namespace reference
