// SPDX-License-Identifier: BSD-3-Clause
// The smallest eigenvectors: running sums of panels, and the error estimate.
#include "linalg/blas_threads.hpp"
#include "linalg/panel.hpp"
#include "ltsa/fit.hpp"
#include "ltsa/testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::Machine;

/// Checks that sums(x) has the same bits with every instruction set and number of threads.
template <class Sums>
Matrix same_everywhere(std::int64_t rows, std::int64_t cols, const Sums& sums) {
    Matrix first(rows, cols);
    sums(first, Machine{Simd::baseline, 1});
    for (const Simd simd : instruction_sets())
        for (const int threads : {1, 3}) {
            Matrix x(rows, cols);
            sums(x, Machine{simd, threads});
            assert_true(std::equal(x.row(0), x.row(rows), first.row(0)));
        }
    return first;
}

void running_sums_are_those_of_their_definition(void**) {
    for (const std::int64_t rows : {1, 7, 1024, 1025, 200001})
        for (const std::int64_t cols : {1, 4, 8})
            for (const double sign : {1.0, -1.0}) {
                const Matrix x = noise(rows, cols, 5), shift = noise(1, cols, 6);
                const Matrix sums = same_everywhere(rows, cols, [&](Matrix& to, Machine machine) {
                    running_sums(x.view(), sign, shift, to.view(), machine);
                });
                for (std::int64_t c = 0; c < cols; ++c) {
                    long double sum = 0;
                    for (std::int64_t i = 0; i < rows; ++i) {
                        sum += sign * (x(i, c) - shift(0, c));
                        ASSERT_NEAR(sums(i, c), static_cast<double>(sum), 1e-9);
                    }
                }
            }
}

stltsa::ltsa::Model fitted(const Matrix& x, int dimension, std::int64_t neighbors) {
    stltsa::ltsa::Parameters parameters;
    parameters.neighbors = parameters.window = neighbors;
    parameters.dimension = dimension;
    const std::int64_t lengths[] = {x.rows()};
    return fit(x.view(), lengths, parameters);
}

/// The spectrum of noise falls slowly: after one solve with ARPACK's vectors, the first correction
/// turns them by 6e-12, after two by less.
void slow_spectra_are_solved_twice(void**) {
    const double error = fitted(noise(500, 6), 3, 12).components[0].error_estimate;
    if (!(error < 3e-12))
        FAIL("%.1e", error);
}

/// A cycle in three features, the second and third of which are much smaller.
Matrix uneven(double share) {
    Matrix x = cyclic(300, 3);
    for (std::int64_t i = 0; i < x.rows(); ++i)
        for (std::int64_t c = 1; c < x.cols(); ++c)
            x(i, c) *= share;
    return x;
}

/// Three neighbors are almost on a line: the first unwanted eigenvalue is rounding, too. With
/// twelve neighbors the line visibly bends.
void the_error_of_rounding_noise_is_unknown(void**) {
    const auto noise = fitted(uneven(1e-4), 1, 3);
    assert_true(noise.components[0].error_estimate == stltsa::ltsa::unknown_error);
    assert_true(noise.warnings.back().text.find("unknown") != std::string::npos);
    for (const double share : {1.0, 1e-4})
        assert_true(fitted(uneven(share), 1, 12).components[0].error_estimate < 1e-8);
    assert_true(fitted(uneven(1), 1, 3).components[0].error_estimate < 1e-8);
}

/// Noise whose columns differ so much in size that corrections never converge.
void the_error_is_unknown_if_corrections_do_not_converge(void**) {
    constexpr double sizes[] = {1e2, 4e-6, 2, 0.3, 5e-3, 4e5};
    Matrix x = noise(127, 6, 9);
    for (std::int64_t i = 0; i < x.rows(); ++i)
        for (std::int64_t c = 0; c < x.cols(); ++c)
            x(i, c) *= sizes[c];
    stltsa::ltsa::Parameters parameters;
    parameters.neighbors = 3;
    parameters.window = 9;
    parameters.dimension = 1;
    parameters.include_self = false;
    const std::int64_t lengths[] = {x.rows()};
    const auto model = fit(x.view(), lengths, parameters);
    assert_true(model.components[0].error_estimate == stltsa::ltsa::unknown_error);
}

} // namespace

int main() {
    const stltsa::SingleThreadedBlas single;
    const CMUnitTest tests[] = {
        cmocka_unit_test(running_sums_are_those_of_their_definition),
        cmocka_unit_test(slow_spectra_are_solved_twice),
        cmocka_unit_test(the_error_of_rounding_noise_is_unknown),
        cmocka_unit_test(the_error_is_unknown_if_corrections_do_not_converge),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
