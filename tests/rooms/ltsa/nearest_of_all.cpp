// SPDX-License-Identifier: BSD-3-Clause
// Compares the nearest rows of all rows with a search over all pairs, to the last bit.
#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"
#include "ltsa/search/all_nearest.hpp"
#include "ltsa/testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::ltsa::Candidate;
using stltsa::ltsa::NearestOfAll;
using stltsa::ltsa::RowRange;

using Lists = std::vector<std::vector<Candidate>>;

/// A circle repeated with small differences, away from the origin.
Matrix cycles(std::int64_t rows, std::int64_t cols, double offset) {
    stltsa::Random random(1);
    Matrix x(rows, cols);
    for (std::int64_t r = 0; r < rows; ++r)
        for (std::int64_t c = 0; c < cols; ++c)
            x(r, c) = offset + std::sin(0.05 * static_cast<double>(r) + static_cast<double>(c)) +
                      0.01 * random.symmetric();
    return x;
}

/// Cycles in which every later row equals an earlier one.
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
    find_nearest_of_all(x.view(), wanted);
    return lists;
}

/// For each row all rows, nearest first.
Lists sorted_for_each(const Matrix& x) {
    Lists lists;
    for (std::int64_t i = 0; i < x.rows(); ++i) {
        std::vector<Candidate> all;
        for (std::int32_t j = 0; j < x.rows(); ++j)
            all.push_back({stltsa::squared_distance(x.row(i), x.row(j), x.cols()), j});
        std::sort(all.begin(), all.end());
        lists.push_back(std::move(all));
    }
    return lists;
}

/// The expected rows among these.
Lists nearest_in(const Lists& sorted, const NearestOfAll& wanted) {
    Lists lists;
    for (const std::vector<Candidate>& all : sorted) {
        const RowRange zone = wanted.zone_of(static_cast<std::int64_t>(lists.size()));
        std::vector<Candidate> nearest;
        for (const Candidate& candidate : all)
            if ((candidate.frame < zone.begin || candidate.frame >= zone.end) &&
                static_cast<std::int64_t>(nearest.size()) < wanted.count)
                nearest.push_back(candidate);
        lists.push_back(std::move(nearest));
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
/// Two clips, one of 100 rows.
RowRange vicinity(std::int64_t row) {
    return row < 100 ? RowRange{std::max(0L, row - 60), std::min(100L, row + 61)}
                     : RowRange{std::max(100L, row - 60), row + 61};
}

/// With any zone and every instruction set.
void compare(const Matrix& x) {
    const Lists sorted = sorted_for_each(x);
    const auto check = [&](const NearestOfAll& wanted) {
        assert_same(found(x, wanted), nearest_in(sorted, wanted));
    };
    for (const std::int64_t count : {1, 12, 50})
        for (const auto zone_of : {nothing, itself, vicinity}) {
            check({count, zone_of, {}, 1, stltsa::widest_simd()});
            for (const Simd simd : instruction_sets())
                check({count, zone_of, {}, 2, simd});
        }
}

void motion_and_noise(void**) {
    for (const std::int64_t cols : {1, 3, 8, 21}) {
        compare(cycles(301, cols, 0));
        compare(shuffled(cycles(301, cols, 0)));
        compare(noise(301, cols, 2));
    }
}

void few_rows(void**) {
    for (const std::int64_t rows : {1, 2, 7, 8, 9, 16, 17, 24, 25, 63})
        compare(cycles(rows, 5, 0));
}

void equal_rows_are_ordered_by_number(void**) {
    compare(Matrix(200, 4));
    compare(repetition(500, 4));
    compare(shuffled(repetition(500, 4)));
    for (const std::int64_t cols : {1, 2, 9})
        compare(lattice(301, cols, 2));
}

/// Rounding or underflowing squares leave few correct digits in the distances.
void numbers_at_the_limits(void**) {
    compare(cycles(301, 9, 1e8));
    compare(cycles(301, 9, 1e14));
    compare(scaled(lattice(301, 9, 2), 1.0 / 3));
    for (const double step : {1e-150, 1e-160, 2.5e-162, 1e-165}) {
        compare(scaled(lattice(301, 2, 2), step));
        compare(scaled(cycles(301, 2, 0), step));
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(motion_and_noise),
        cmocka_unit_test(few_rows),
        cmocka_unit_test(equal_rows_are_ordered_by_number),
        cmocka_unit_test(numbers_at_the_limits),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
