// SPDX-License-Identifier: BSD-3-Clause
// The usual algorithm, which the library does not use: B plus a shift, factored.
#include "reference.hpp"

#include <arpack.h>
#include <lapacke.h>

namespace reference {
namespace {

/// B(I_i, I_i) += I - e e^T / k - G_i G_i^T: step 4 of the paper's Table 1.
Band<double> alignment(const Neighbors& neighbors, const Tangents<double>& tangents,
                       std::size_t d) {
    const std::size_t k = neighbors.cols;
    Band<double> matrix(neighbors.rows, widest_span(neighbors));
    for (std::size_t i = 0; i < neighbors.rows; ++i)
        for (std::size_t b = 0; b < k; ++b)
            for (std::size_t a = b; a < k; ++a) {
                double entry = (a == b ? 1.0 : 0.0) - 1 / static_cast<double>(k);
                for (std::size_t l = 0; l < d; ++l)
                    entry -= tangents.of(i, l)[a] * tangents.of(i, l)[b];
                matrix.at(neighbors(i, a), neighbors(i, b)) += entry;
            }
    return matrix;
}

/// A band matrix in LAPACK's layout.
struct LapackBand {
    Band<double>& band;
    lapack_int order = static_cast<lapack_int>(band.rows());
    lapack_int below = static_cast<lapack_int>(band.half_width());

    bool factor() {
        return LAPACKE_dpbtrf(LAPACK_COL_MAJOR, 'L', order, below, &band.at(0, 0), below + 1) == 0;
    }
    void solve(double* x) {
        LAPACKE_dpbtrs(LAPACK_COL_MAJOR, 'L', order, below, 1, &band.at(0, 0), below + 1, x, order);
    }
};

/// Eigenvectors of the d + 1 largest eigenvalues of the inverse, descending, without the first one.
std::optional<Table<double>> largest_but_one(LapackBand matrix, std::size_t d) {
    const a_int n = matrix.order;
    const auto wanted = static_cast<a_int>(d + 1);
    constexpr a_int vectors = 20;
    Table<double> basis(vectors, static_cast<std::size_t>(n));
    std::vector<double> residual(basis.cols, 0.0);
    for (std::size_t i = 0; i < basis.cols; ++i) // rough, and identical in every run
        residual[i] = static_cast<double>((i * i * 7 + i * 3) % 1009) / 1009 - 0.5;
    std::vector<double> work(3 * basis.cols);
    std::vector<double> small(vectors * (vectors + 8));
    const auto small_size = static_cast<a_int>(small.size());
    a_int parameters[11] = {1, 0, 100, 1, 0, 0, 1};
    a_int pointers[11] = {};
    a_int ido = 0;
    a_int info = 1;
    for (;;) {
        dsaupd_c(&ido, "I", n, "LM", wanted, 0.0, residual.data(), vectors, basis.values.data(), n,
                 parameters, pointers, work.data(), small.data(), small_size, &info);
        if (ido != 1 && ido != -1)
            break;
        double* out = work.data() + pointers[1] - 1;
        std::copy_n(work.data() + pointers[0] - 1, n, out);
        matrix.solve(out);
    }
    if (info != 0)
        return std::nullopt;
    std::vector<a_int> select(vectors, 1);
    std::vector<double> values(d + 1);
    Table<double> found(d + 1, basis.cols);
    dseupd_c(1, "A", select.data(), values.data(), found.values.data(), n, 0.0, "I", n, "LM",
             wanted, 0.0, residual.data(), vectors, basis.values.data(), n, parameters, pointers,
             work.data(), small.data(), small_size, &info);
    if (info != 0)
        return std::nullopt;
    found.values.resize(d * basis.cols); // ascending: the last is the constant one
    found.rows = d;
    return found;
}

} // namespace

std::optional<Table<double>> embed_by_shift(const Neighbors& neighbors,
                                            const Tangents<double>& tangents, std::size_t d,
                                            double shift) {
    Band<double> matrix = alignment(neighbors, tangents, d);
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        matrix.at(i, i) += shift;
    LapackBand lapack{matrix};
    if (!lapack.factor())
        return std::nullopt;
    return largest_but_one(lapack, d);
}

} // namespace reference
