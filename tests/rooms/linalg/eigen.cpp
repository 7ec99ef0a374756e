// SPDX-License-Identifier: BSD-3-Clause
// The largest eigenpairs, from LAPACK (also if its fast routine fails) and from ARPACK.
#include "assertions.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <thread>

#include "base/random.hpp"
#include "checkpoints.hpp"
#include "linalg/arpack.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"

namespace {

using stltsa::TopEigenpairs;

constexpr std::int64_t order = 39;
constexpr std::int64_t count = 3;

/// Checks that vectors are orthonormal and eigenvectors of the matrix (lower triangle, by columns).
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

/// The inverse of the second-difference matrix: eigenvalues 1 / (4 sin^2 (l pi / 2 (n + 1))).
void fill_known(double* matrix) {
    for (std::int64_t j = 0; j < order; ++j)
        for (std::int64_t i = j; i < order; ++i)
            matrix[j * order + i] =
                static_cast<double>((j + 1) * (order - i)) / static_cast<double>(order + 1);
}

void check_known(const TopEigenpairs& pairs, std::int64_t values) {
    for (std::int64_t p = 0; p < values; ++p) {
        const double sine = std::sin(static_cast<double>(p + 1) * std::acos(-1.0) /
                                     (2 * static_cast<double>(order + 1)));
        ASSERT_NEAR(pairs.value(p), 1 / (4 * sine * sine), 1e-11);
    }
}

void a_known_spectrum(void**) {
    TopEigenpairs pairs(order, count);
    fill_known(pairs.matrix());
    pairs.solve();
    check_known(pairs, count);
    check_pairs(pairs, pairs.matrix(), 1e-11);
}

void values_without_vectors(void**) {
    TopEigenpairs all(order, order);
    fill_known(all.matrix());
    all.solve_values();
    check_known(all, order);
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

/// Two decoupled blocks: 200 eigenvalues from 1 / 2 to 1, and as many from 2 to 4.
void two_ranges(std::span<const double> x, std::span<double> y) {
    const std::size_t half = x.size() / 2;
    for (std::size_t i = 0; i < x.size(); ++i)
        y[i] = (i < half ? 0.5 : 2) * (1 + static_cast<double>(i % half) / 199) * x[i];
}

/// ARPACK searches only the blocks that the start vector touches.
void the_start_vector_decides(void**) {
    const auto largest = [](std::size_t entries) {
        const auto start = [entries](std::span<double> x) {
            std::fill(x.begin(), x.end(), 0.0);
            std::fill_n(x.begin(), entries, 1.0);
        };
        return stltsa::largest_eigenpairs(two_ranges, 400, start, 2).values[0];
    };
    ASSERT_NEAR(largest(400), 4, 1e-8);
    ASSERT_NEAR(largest(200), 1, 1e-8);
}

/// Small orders, solved densely; and ARPACK, without restarts and, if the values are close, with
/// restarts.
template <class Value>
void check_diagonal(std::int64_t entries, const Value& value, double rounding) {
    const auto apply = [value](std::span<const double> x, std::span<double> y) {
        for (std::size_t i = 0; i < x.size(); ++i)
            y[i] = value(static_cast<std::int64_t>(i)) * x[i];
    };
    const auto start = [](std::span<double> x) { std::fill(x.begin(), x.end(), 1.0); };
    constexpr std::int64_t wanted = 4;
    const auto pairs = stltsa::largest_eigenpairs(apply, entries, start, wanted);
    for (std::int64_t j = 0; j < wanted; ++j) {
        const double found = pairs.values[static_cast<std::size_t>(j)];
        ASSERT_NEAR(found / value(j), 1, 10 * rounding);
        const double* v = pairs.vectors.row(j);
        assert_true(std::abs(v[j]) > 1 - 1e-9);
        for (std::int64_t l = 0; l < wanted; ++l)
            ASSERT_NEAR(stltsa::dot(v, pairs.vectors.row(l), entries), j == l ? 1 : 0, rounding);
    }
}

void pairs_are_eigenpairs(void**) {
    for (const double spread : {0.01, 1.0, 30.0})
        for (const std::int64_t entries : {50, 400, 4000})
            check_diagonal(
                entries,
                [spread](std::int64_t i) { return 1 / (1 + spread * static_cast<double>(i)); },
                1e-13);
}

/// Rounding hides values 10^12 times smaller than the largest. The caller must correct the error
/// that a value of 10^24 or more leaves in the others; on arm64 it is 1.3e-6.
void small_eigenvalues_are_found_beside_large_ones(void**) {
    for (const std::int64_t large : {1, 2})
        for (const std::int64_t entries : {50, 400, 4000})
            check_diagonal(
                entries,
                [large](std::int64_t i) {
                    return (i < large ? std::pow(1e12, static_cast<double>(large - i)) : 1.0) /
                           static_cast<double>(1 + i);
                },
                large == 1 ? 1e-12 : 1e-5);
}

struct Stop {};

/// ARPACK serves one thread at a time; a waiting thread can be cancelled.
void a_waiting_thread_can_be_stopped(void**) {
    const auto start = [](std::span<double> x) { std::fill(x.begin(), x.end(), 1.0); };
    bool stopped = false;
    const auto wait = [&] {
        const testing::Answering stop([] { throw Stop{}; });
        try {
            stltsa::largest_eigenpairs(two_ranges, 400, start, 2);
        } catch (const Stop&) {
            stopped = true;
        }
    };
    const testing::Answering beside([&] {
        if (!stopped)
            std::thread(wait).join();
    });
    const auto pairs = stltsa::largest_eigenpairs(two_ranges, 400, start, 2);
    assert_true(stopped);
    ASSERT_NEAR(pairs.values[0], 4, 1e-8);
}

} // namespace

int main() {
    const stltsa::SingleThreadedBlas single;
    const CMUnitTest tests[] = {
        cmocka_unit_test(the_start_vector_decides),
        cmocka_unit_test(pairs_are_eigenpairs),
        cmocka_unit_test(small_eigenvalues_are_found_beside_large_ones),
        cmocka_unit_test(a_waiting_thread_can_be_stopped),
        cmocka_unit_test(a_known_spectrum),
        cmocka_unit_test(values_without_vectors),
        cmocka_unit_test(nearly_the_identity),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
