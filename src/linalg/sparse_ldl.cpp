// SPDX-License-Identifier: BSD-3-Clause
// LDL provides the factorization for builds without code under the GPL. It eliminates one column at
// a time, without the dense blocks that make CHOLMOD fast on large matrices.
#include "linalg/sparse_factor.hpp"

#include <algorithm>
#include <new>

#include <suitesparse/amd.h>
extern "C" {
#include <suitesparse/ldl.h>
}

#include "base/error.hpp"

namespace stltsa {
namespace {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
using Indices = std::vector<SuiteSparse_long>;

std::size_t at(std::int64_t index) {
    return static_cast<std::size_t>(index);
}

Indices minimum_degree(const SparseColumns& matrix) {
    Indices order(at(matrix.order));
    const auto status = amd_l_order(matrix.order, matrix.begin.data(), matrix.rows.data(),
                                    order.data(), nullptr, nullptr);
    if (status == AMD_OUT_OF_MEMORY)
        throw std::bad_alloc();
    if (status != AMD_OK)
        fail(Status::internal, "AMD failed (status {})", status);
    return order;
}

} // namespace

struct SparseFactor::State {
    explicit State(SparseColumns& matrix)
        : order(matrix.order), row_of(minimum_degree(matrix)), place_of(row_of.size()),
          begin(row_of.size() + 1), parent(row_of.size()), counts(row_of.size()),
          marks(row_of.size()), pattern(row_of.size()), work(row_of.size()), pivots(row_of.size()) {
        for (SuiteSparse_long i = 0; i < order; ++i)
            place_of[at(row_of[at(i)])] = i;
        reorder(matrix);
        ldl_l_symbolic(order, columns.begin.data(), columns.rows.data(), begin.data(),
                       parent.data(), counts.data(), marks.data(), nullptr, nullptr);
        rows.resize(at(begin.back()));
        values.resize(at(begin.back()));
    }

    /// LDL reads the upper triangle by columns.
    void reorder(const SparseColumns& matrix) {
        columns = {order, Indices(at(order) + 1), Indices(matrix.rows.size()),
                   std::vector<double>(matrix.rows.size())};
        const auto column_of = [&](std::int64_t c, std::size_t entry) {
            return std::max(place_of[at(c)], place_of[at(matrix.rows[entry])]);
        };
        for_each_entry(matrix, [&](std::int64_t c, std::size_t entry) {
            ++columns.begin[at(column_of(c, entry)) + 1];
        });
        for (std::size_t c = 1; c < columns.begin.size(); ++c)
            columns.begin[c] += columns.begin[c - 1];
        Indices next = columns.begin;
        for_each_entry(matrix, [&](std::int64_t c, std::size_t entry) {
            const auto to = at(next[at(column_of(c, entry))]++);
            columns.rows[to] = std::min(place_of[at(c)], place_of[at(matrix.rows[entry])]);
            columns.values[to] = matrix.values[entry];
        });
    }

    template <class Work>
    static void for_each_entry(const SparseColumns& matrix, const Work& work) {
        for (std::int64_t c = 0; c < matrix.order; ++c)
            for (auto e = matrix.begin[at(c)]; e < matrix.begin[at(c) + 1]; ++e)
                work(c, at(e));
    }

    void shift_diagonal(double shift) {
        for (std::int64_t c = 0; c < order; ++c)
            for (auto e = columns.begin[at(c)]; e < columns.begin[at(c) + 1]; ++e)
                if (columns.rows[at(e)] == c)
                    columns.values[at(e)] += shift;
    }

    SuiteSparse_long order;
    Indices row_of, place_of; ///< the row of the matrix for each row of the factor, and the inverse
    SparseColumns columns;    ///< the reordered matrix
    Indices begin, rows;      ///< of the factor's columns, without the diagonal
    std::vector<double> values;
    Indices parent, counts, marks, pattern;
    std::vector<double> work, pivots;
};

SparseFactor::SparseFactor(SparseColumns& matrix) : state_(std::make_unique<State>(matrix)) {}

SparseFactor::~SparseFactor() = default;

bool SparseFactor::factorize(SparseColumns&, double shift) {
    State& s = *state_;
    s.shift_diagonal(shift);
    const auto done = ldl_l_numeric(
        s.order, s.columns.begin.data(), s.columns.rows.data(), s.columns.values.data(),
        s.begin.data(), s.parent.data(), s.counts.data(), s.rows.data(), s.values.data(),
        s.pivots.data(), s.work.data(), s.pattern.data(), s.marks.data(), nullptr, nullptr);
    return done == s.order &&
           std::all_of(s.pivots.begin(), s.pivots.end(), [](double p) { return p > 0; });
}

double SparseFactor::pivot_ratio() const {
    const auto [least, largest] = std::minmax_element(state_->pivots.begin(), state_->pivots.end());
    return *least / *largest;
}

void SparseFactor::solve(MatrixView rows) {
    State& s = *state_;
    for (std::int64_t r = 0; r < rows.rows; ++r) {
        ldl_l_perm(s.order, s.work.data(), rows.row(r), s.row_of.data());
        ldl_l_lsolve(s.order, s.work.data(), s.begin.data(), s.rows.data(), s.values.data());
        ldl_l_dsolve(s.order, s.work.data(), s.pivots.data());
        ldl_l_ltsolve(s.order, s.work.data(), s.begin.data(), s.rows.data(), s.values.data());
        ldl_l_permt(s.order, rows.row(r), s.work.data(), s.row_of.data());
    }
}

} // namespace stltsa
