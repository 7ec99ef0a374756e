// SPDX-License-Identifier: BSD-3-Clause
// The largest eigenpairs, by LAPACK also where its quick routine finds none, and by ARPACK.
#include "testing.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/random.hpp"
#include "linalg/arpack.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"

namespace {

using stltsa::TopEigenpairs;

constexpr std::int64_t order = 39;
constexpr std::int64_t count = 3;

/// Orthonormal, and the matrix (its lower triangle by columns) times each is its value times it.
void check_pairs(const TopEigenpairs& pairs, const double* matrix, double tolerance) {
    for (std::int64_t p = 0; p < count; ++p) {
        const double* v = pairs.vector(p);
        for (std::int64_t q = 0; q <= p; ++q)
            ASSERT_NEAR(stltsa::dot(v, pairs.vector(q), order), p == q ? 1 : 0, 1e-13);
        for (std::int64_t i = 0; i < order; ++i) {
            double product = 0;
            for (std::int64_t j = 0; j < order; ++j)
                product += v[j] * (i > j ? matrix[j * order + i] : matrix[i * order + j]);
            ASSERT_NEAR(product, pairs.value(p) * v[i], tolerance);
        }
    }
}

void a_known_spectrum(void**) {
    TopEigenpairs pairs(order, count);
    // The inverse of the second difference's matrix: eigenvalues 1 / (4 sin^2 (l pi / 2 (n + 1))).
    for (std::int64_t j = 0; j < order; ++j)
        for (std::int64_t i = j; i < order; ++i)
            pairs.matrix()[j * order + i] =
                static_cast<double>((j + 1) * (order - i)) / static_cast<double>(order + 1);
    pairs.solve();
    for (std::int64_t p = 0; p < count; ++p) {
        const double sine = std::sin(static_cast<double>(p + 1) * std::acos(-1.0) /
                                     (2 * static_cast<double>(order + 1)));
        ASSERT_NEAR(pairs.value(p), 1 / (4 * sine * sine), 1e-11);
    }
    check_pairs(pairs, pairs.matrix(), 1e-11);
}

void nearly_the_identity(void**) {
    stltsa::Random random(5);
    TopEigenpairs pairs(order, count);
    for (int trial = 0; trial < 300; ++trial) {
        for (std::int64_t j = 0; j < order; ++j)
            for (std::int64_t i = j; i < order; ++i)
                pairs.matrix()[j * order + i] = (i == j ? 1 : 0) + 1e-16 * random.symmetric();
        pairs.solve();
        check_pairs(pairs, pairs.matrix(), 1e-14);
    }
}

/// Two parts that know nothing of each other: 200 values of 1 / 2 to 1, and as many of 2 to 4.
void two_parts(std::span<const double> x, std::span<double> y) {
    const std::size_t half = x.size() / 2;
    for (std::size_t i = 0; i < x.size(); ++i)
        y[i] = (i < half ? 0.5 : 2) * (1 + static_cast<double>(i % half) / 199) * x[i];
}

/// The start says where ARPACK looks: all of it, and nothing else.
void the_start_is_ours(void**) {
    const auto largest = [](std::size_t entries) {
        const auto start = [entries](std::span<double> x) {
            std::fill(x.begin(), x.end(), 0.0);
            std::fill_n(x.begin(), entries, 1.0);
        };
        return stltsa::largest_eigenpairs(two_parts, 400, start, 2, {}, [] {}).values[0];
    };
    ASSERT_NEAR(largest(400), 4, 1e-8);
    ASSERT_NEAR(largest(200), 1, 1e-8);
}

} // namespace

int main() {
    const stltsa::SingleThreadedBlas single;
    const CMUnitTest tests[] = {
        cmocka_unit_test(the_start_is_ours),
        cmocka_unit_test(a_known_spectrum),
        cmocka_unit_test(nearly_the_identity),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
