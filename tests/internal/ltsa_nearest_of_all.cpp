// SPDX-License-Identifier: BSD-3-Clause
// The nearest rows of all rows against comparing every pair, to the last bit.
#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "linalg/simd.hpp"
#include "ltsa/nearest_of_all.hpp"
#include "motion_testing.hpp"

namespace {

using namespace motion_testing;
using stltsa::Simd;
using stltsa::ltsa::Candidate;
using stltsa::ltsa::NearestOfAll;
using stltsa::ltsa::RowRange;

using Lists = std::vector<std::vector<Candidate>>;

/// A circle that is run through again and again, never quite the same way, away from the origin.
Matrix cycles(std::int64_t rows, std::int64_t cols, double offset) {
    stltsa::Random random(1);
    Matrix x(rows, cols);
    for (std::int64_t r = 0; r < rows; ++r)
        for (std::int64_t c = 0; c < cols; ++c)
            x(r, c) = offset + std::sin(0.05 * static_cast<double>(r) + static_cast<double>(c)) +
                      0.01 * random.symmetric();
    return x;
}

Matrix noise(std::int64_t rows, std::int64_t cols) {
    stltsa::Random random(2);
    Matrix x(rows, cols);
    for (std::int64_t i = 0; i < rows * cols; ++i)
        x.data()[i] = random.symmetric();
    return x;
}

/// Of few different values, so that many distances are equal, at all scales.
Matrix lattice(std::int64_t rows, std::int64_t cols, double step) {
    Matrix x = noise(rows, cols);
    for (std::int64_t i = 0; i < rows * cols; ++i)
        x.data()[i] = step * std::round(1.5 * x.data()[i]);
    return x;
}

/// Cycles of which every later row equals an earlier one.
Matrix repetition(std::int64_t rows, std::int64_t cols) {
    Matrix x = cycles(rows, cols, 0);
    for (std::int64_t r = rows / 3; r < rows; ++r)
        std::copy_n(x.row(r % (rows / 3)), cols, x.row(r));
    return x;
}

/// The same rows in another order.
Matrix shuffled(const Matrix& x) {
    Matrix result(x.rows(), x.cols());
    for (std::int64_t r = 0; r < x.rows(); ++r)
        std::copy_n(x.row(r * 7919 % x.rows()), x.cols(), result.row(r));
    return result;
}

Lists found(const Matrix& x, NearestOfAll wanted) {
    Lists lists(static_cast<std::size_t>(x.rows()));
    wanted.store = [&](std::int64_t row, std::vector<Candidate> nearest) {
        lists[static_cast<std::size_t>(row)] = std::move(nearest);
    };
    find_nearest_of_all(x.view(), wanted, [](double) {});
    return lists;
}

Lists by_sorting(const Matrix& x, const NearestOfAll& wanted) {
    Lists lists;
    for (std::int64_t i = 0; i < x.rows(); ++i) {
        const RowRange zone = wanted.zone_of(i);
        std::vector<Candidate> all;
        for (std::int32_t j = 0; j < x.rows(); ++j)
            if (j < zone.begin || j >= zone.end)
                all.push_back({stltsa::squared_distance(x.row(i), x.row(j), x.cols()), j});
        std::sort(all.begin(), all.end());
        all.resize(std::min(all.size(), static_cast<std::size_t>(wanted.count)));
        lists.push_back(all);
    }
    return lists;
}

void assert_same(const Lists& actual, const Lists& expected) {
    const auto same = [](const Candidate& a, const Candidate& b) {
        return a.frame == b.frame && a.distance == b.distance;
    };
    assert_int_equal(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i)
        assert_true(std::equal(actual[i].begin(), actual[i].end(), expected[i].begin(),
                               expected[i].end(), same));
}

RowRange nothing(std::int64_t) {
    return {0, 0};
}
RowRange itself(std::int64_t row) {
    return {row, row + 1};
}
/// Of two clips, one of 100 rows.
RowRange vicinity(std::int64_t row) {
    return row < 100 ? RowRange{std::max(0L, row - 60), std::min(100L, row + 61)}
                     : RowRange{std::max(100L, row - 60), row + 61};
}

void compare(const Matrix& x) {
    for (const std::int64_t count : {1, 12, 50})
        for (const auto zone_of : {nothing, itself, vicinity}) {
            NearestOfAll wanted{count, zone_of, {}, 1, stltsa::widest_simd()};
            const Lists expected = by_sorting(x, wanted);
            assert_same(found(x, wanted), expected);
            wanted.threads = 2;
            for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
                wanted.simd = simd;
                if (simd_available(simd))
                    assert_same(found(x, wanted), expected);
            }
        }
}

void motion_and_noise(void**) {
    for (const std::int64_t cols : {1, 3, 8, 21}) {
        compare(cycles(301, cols, 0));
        compare(shuffled(cycles(301, cols, 0)));
        compare(noise(301, cols));
    }
}

void few_rows(void**) {
    for (const std::int64_t rows : {1, 2, 7, 8, 9, 16, 17, 24, 25, 63})
        compare(cycles(rows, 5, 0));
}

void equal_rows_come_by_number(void**) {
    compare(Matrix(200, 4));
    compare(repetition(500, 4));
    compare(shuffled(repetition(500, 4)));
    for (const std::int64_t cols : {1, 2, 9})
        compare(lattice(301, cols, 1));
}

/// Where rounding, or squares that underflow, take nearly all digits from the distances.
void numbers_at_the_limits(void**) {
    compare(cycles(301, 9, 1e8));
    compare(cycles(301, 9, 1e14));
    compare(lattice(301, 9, 1.0 / 3));
    for (const double step : {1e-150, 1e-160, 2.5e-162, 1e-165}) {
        compare(lattice(301, 2, step));
        Matrix x = cycles(301, 2, 0);
        for (std::int64_t i = 0; i < x.rows() * x.cols(); ++i)
            x.data()[i] *= step;
        compare(x);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(motion_and_noise),
        cmocka_unit_test(few_rows),
        cmocka_unit_test(equal_rows_come_by_number),
        cmocka_unit_test(numbers_at_the_limits),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
