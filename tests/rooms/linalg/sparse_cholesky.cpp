// SPDX-License-Identifier: BSD-3-Clause
// Sparse Cholesky factors: known solutions are found for matrices of every structure, singular ones
// get a shift, and matrices that are not positive are refused.
#include "linalg/sparse_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "assertions.hpp"
#include "base/random.hpp"

namespace {

using stltsa::Matrix;
using stltsa::Random;
using stltsa::SparseCholesky;
using stltsa::SparseColumns;

/// Entries of the lower triangle by (column, row).
using Entries = std::map<std::pair<std::int64_t, std::int64_t>, double>;

SparseColumns columns(std::int64_t order, const Entries& entries) {
    SparseColumns matrix{order, {}, {}, {}};
    for (const auto& [place, value] : entries) {
        while (static_cast<std::int64_t>(matrix.begin.size()) <= place.first)
            matrix.begin.push_back(static_cast<std::int64_t>(matrix.rows.size()));
        matrix.rows.push_back(place.second);
        matrix.values.push_back(value);
    }
    matrix.begin.push_back(static_cast<std::int64_t>(matrix.rows.size()));
    return matrix;
}

/// The Laplacian of a graph, whose rows sum to zero, plus `more` on the diagonal.
class Graph {
  public:
    explicit Graph(std::int64_t order, double more) : order_(order) {
        for (std::int64_t i = 0; i < order; ++i)
            entries_[{i, i}] = more;
    }
    void join(std::int64_t a, std::int64_t b, double weight = 1) {
        if (a == b)
            return;
        entries_[{std::min(a, b), std::max(a, b)}] -= weight;
        entries_[{a, a}] += weight;
        entries_[{b, b}] += weight;
    }
    SparseColumns matrix() const { return columns(order_, entries_); }

  private:
    std::int64_t order_;
    Entries entries_;
};

/// y := matrix x for each row.
Matrix product(const SparseColumns& matrix, const Matrix& x) {
    Matrix y(x.rows(), x.cols());
    for (std::int64_t r = 0; r < x.rows(); ++r)
        for (std::int64_t c = 0; c < matrix.order; ++c)
            for (auto e = matrix.begin[static_cast<std::size_t>(c)];
                 e < matrix.begin[static_cast<std::size_t>(c) + 1]; ++e) {
                const std::int64_t row = matrix.rows[static_cast<std::size_t>(e)];
                const double value = matrix.values[static_cast<std::size_t>(e)];
                y(r, row) += value * x(r, c);
                if (row != c)
                    y(r, c) += value * x(r, row);
            }
    return y;
}

Matrix random_rows(std::int64_t rows, std::int64_t cols) {
    Random random(1);
    Matrix x(rows, cols);
    for (std::int64_t i = 0; i < rows * cols; ++i)
        x.data()[i] = random.symmetric();
    return x;
}

void check_solution(const SparseColumns& matrix) {
    const SparseCholesky factor(matrix);
    for (const std::int64_t count : {1, 5}) {
        const Matrix x = random_rows(count, matrix.order);
        Matrix right = product(matrix, x);
        factor.solve(right.view());
        for (std::int64_t i = 0; i < count * matrix.order; ++i)
            ASSERT_NEAR(right.data()[i], x.data()[i], 1e-11);
    }
}

void solutions_are_found(void**) {
    check_solution(columns(1, {{{0, 0}, 4}}));
    check_solution(Graph(40, 1).matrix()); // diagonal: every supernode is a root
    Graph path(500, 0.5), star(300, 0.5), full(90, 0.5), apart(200, 0.5);
    for (std::int64_t i = 1; i < 500; ++i)
        path.join(i - 1, i);
    for (std::int64_t i = 1; i < 300; ++i)
        star.join(7, i);
    for (std::int64_t i = 0; i < 90; ++i)
        for (std::int64_t j = 0; j < i; ++j)
            full.join(i, j, 0.1);
    for (std::int64_t i = 0; i + 2 < 200; ++i)
        apart.join(i, i + 2); // two components
    check_solution(path.matrix());
    check_solution(star.matrix());
    check_solution(full.matrix());
    check_solution(apart.matrix());
}

void grids_and_random_graphs_are_solved(void**) {
    constexpr std::int64_t side = 40;
    Graph grid(side * side, 0.1);
    for (std::int64_t i = 0; i < side * side; ++i) {
        if (i % side + 1 < side)
            grid.join(i, i + 1);
        if (i + side < side * side)
            grid.join(i, i + side);
    }
    check_solution(grid.matrix());
    Random random(5);
    const auto below = [&](std::int64_t n) {
        return static_cast<std::int64_t>((random.symmetric() + 1) / 2 * static_cast<double>(n - 1));
    };
    for (int trial = 0; trial < 60; ++trial) {
        const std::int64_t order = 2 + below(150);
        Graph graph(order, 0.2);
        for (std::int64_t edges = below(4 * order); edges > 0; --edges)
            graph.join(below(order), below(order));
        check_solution(graph.matrix());
    }
}

/// The solution is determined up to the null vector; the shift keeps that part finite.
void singular_matrices_get_a_shift(void**) {
    Graph ring(300, 0);
    for (std::int64_t i = 0; i < 300; ++i)
        ring.join(i, (i + 1) % 300);
    const SparseColumns matrix = ring.matrix();
    const SparseCholesky factor(matrix);
    const Matrix right = product(matrix, random_rows(1, 300));
    Matrix x = right;
    factor.solve(x.view());
    const Matrix again = product(matrix, x);
    for (std::int64_t i = 0; i < 300; ++i)
        ASSERT_NEAR(again(0, i), right(0, i), 1e-6);
}

void indefinite_matrices_are_refused(void**) {
    Graph path(100, 0);
    for (std::int64_t i = 1; i < 100; ++i)
        path.join(i - 1, i, i == 50 ? -1 : 1);
    try {
        const SparseCholesky factor(path.matrix());
        FAIL("a negative weight makes the matrix indefinite");
    } catch (const stltsa::Error& error) {
        assert_true(error.status() == stltsa::Status::degenerate);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(solutions_are_found),
        cmocka_unit_test(grids_and_random_graphs_are_solved),
        cmocka_unit_test(singular_matrices_get_a_shift),
        cmocka_unit_test(indefinite_matrices_are_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
