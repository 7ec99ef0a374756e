// SPDX-License-Identifier: BSD-3-Clause
// The nearest rows against comparing every pair, and the order of rows in time.
#include <numeric>

#include "base/random.hpp"
#include "linalg/simd.hpp"
#include "ltsa/nearest.hpp"
#include "ltsa/timeline.hpp"
#include "motion_testing.hpp"

namespace {

using namespace motion_testing;
using stltsa::ltsa::Candidate;
using stltsa::ltsa::NearestRows;
using stltsa::ltsa::RowRange;
using stltsa::ltsa::Timeline;

/// A wandering curve, as motion is, every seventh row equal to an earlier one.
Matrix curve(std::int64_t rows, std::int64_t cols, std::uint64_t seed) {
    stltsa::Random random(seed);
    Matrix x(rows, cols);
    for (std::int64_t r = 0; r < rows; ++r)
        for (std::int64_t c = 0; c < cols; ++c)
            x(r, c) =
                r % 7 == 6 ? x(r / 2, c) : (r > 0 ? x(r - 1, c) : 1000) + 0.1 * random.symmetric();
    return x;
}

/// Whole numbers, so that many distances are equal.
Matrix lattice(std::int64_t rows, std::int64_t cols, std::uint64_t seed) {
    stltsa::Random random(seed);
    Matrix x(rows, cols);
    for (std::int64_t i = 0; i < rows * cols; ++i)
        x.data()[i] = std::round(1.5 * random.symmetric());
    return x;
}

std::vector<std::int32_t> every(std::int64_t rows, std::int64_t step) {
    std::vector<std::int32_t> result;
    for (std::int64_t r = 0; r < rows; r += step)
        result.push_back(static_cast<std::int32_t>(r));
    return result;
}

/// The same by sorting all rows that are allowed.
template <class Allowed>
std::vector<Candidate> by_sorting(ConstMatrixView x, const std::vector<std::int32_t>& rows,
                                  const double* query, std::int64_t count, const Allowed& allowed) {
    std::vector<Candidate> all;
    for (const std::int32_t row : rows)
        if (allowed(row))
            all.push_back({stltsa::squared_distance(query, x.row(row), x.cols), row});
    std::sort(all.begin(), all.end());
    all.resize(std::min(all.size(), static_cast<std::size_t>(count)));
    return all;
}

void assert_equal(const std::vector<Candidate>& found, const std::vector<Candidate>& expected) {
    assert_int_equal(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        assert_int_equal(found[i].frame, expected[i].frame);
        assert_true(found[i].distance == expected[i].distance);
    }
}

void compare(const Matrix& x, std::int64_t step) {
    const std::vector<std::int32_t> rows = every(x.rows(), step);
    const NearestRows nearest(x.view(), rows);
    assert_true(nearest.rows() == rows);
    stltsa::Random random(99);
    std::vector<double> query(static_cast<std::size_t>(x.cols()));
    for (std::int64_t q = 0; q < x.rows(); q += 1 + x.rows() / 40) {
        // A row, near one, and far away.
        const double off = q % 3 == 0 ? 0 : q % 3 == 1 ? 0.05 : 20;
        for (std::size_t c = 0; c < query.size(); ++c)
            query[c] = x.row(q)[c] + off * random.symmetric();
        for (const std::int64_t count : {std::int64_t{1}, std::int64_t{11}, 2 * x.rows()}) {
            assert_equal(nearest.nearest(query.data(), count),
                         by_sorting(x.view(), rows, query.data(), count, [](int) { return true; }));
            for (const RowRange range :
                 {RowRange{q - 9, q + 4}, RowRange{q, x.rows()}, RowRange{-5, 3}, RowRange{q, q}}) {
                const auto inside = [&](int row) { return row >= range.begin && row < range.end; };
                const auto outside = [&](int row) { return !inside(row); };
                assert_equal(nearest.nearest_within(query.data(), count, range),
                             by_sorting(x.view(), rows, query.data(), count, inside));
                assert_equal(nearest.nearest_outside(query.data(), count, range),
                             by_sorting(x.view(), rows, query.data(), count, outside));
            }
        }
    }
}

void same_rows_as_comparing_all(void**) {
    for (const std::int64_t rows : {1, 2, 16, 17, 33, 700})
        for (const std::int64_t cols : {1, 3, 20}) {
            compare(curve(rows, cols, 5), 1);
            compare(curve(rows, cols, 6), 3);
            compare(lattice(rows, cols, 7), 1);
        }
}

void none_asked_or_none_there(void**) {
    const Matrix x = curve(50, 4, 1);
    const NearestRows nearest(x.view(), every(50, 1));
    const NearestRows empty(x.view(), {});
    assert_true(nearest.nearest(x.row(3), 0).empty());
    assert_true(nearest.nearest_within(x.row(3), 0, {0, 9}).empty());
    assert_true(empty.nearest(x.row(3), 5).empty());
    assert_true(empty.nearest_within(x.row(3), 5, {0, 9}).empty());
    assert_true(nearest.holds(49) && !nearest.holds(50) && !empty.holds(0));
}

/// Squares that overflow: every row is infinitely far, and the first ones are the nearest.
void rows_beyond_measure(void**) {
    Matrix x = lattice(100, 3, 2);
    for (std::int64_t i = 0; i < 300; ++i)
        x.data()[i] *= 1e200;
    const NearestRows nearest(x.view(), every(100, 1));
    const double query[] = {3e200, 3e200, 3e200};
    const auto found = nearest.nearest(query, 4);
    assert_int_equal(found.size(), 4);
    for (std::size_t i = 0; i < 4; ++i) {
        assert_int_equal(found[i].frame, i);
        assert_true(std::isinf(found[i].distance));
    }
}

/// Rows 0 0 1 2 2 2 | 2 3 3.
Timeline with_repeats() {
    Matrix x(9, 1);
    const double values[] = {0, 0, 1, 2, 2, 2, 2, 3, 3};
    std::copy(values, values + 9, x.data());
    const std::int64_t lengths[] = {6, 3};
    return {x.view(), lengths};
}

void repeats_have_an_original(void**) {
    const Timeline timeline = with_repeats();
    const std::vector<std::int32_t> distinct{0, 2, 3, 6, 7};
    assert_true(timeline.distinct() == distinct);
    const std::int64_t originals[] = {0, 0, 2, 3, 3, 3, 6, 7, 7};
    const std::int64_t next[] = {2, 2, 3, -1, -1, -1, 7, -1, -1};
    for (std::int64_t row = 0; row < 9; ++row) {
        assert_int_equal(timeline.original(row), originals[row]);
        assert_int_equal(timeline.next(row), next[row]);
    }
}

void windows_count_originals_and_end_with_the_clip(void**) {
    const Timeline timeline = with_repeats();
    const auto is = [&](std::int64_t row, std::int64_t reach, std::int64_t begin,
                        std::int64_t end) {
        const RowRange range = timeline.around(row, reach);
        assert_int_equal(range.begin, begin);
        assert_int_equal(range.end, end);
    };
    is(1, 0, 0, 1);
    is(1, 1, 0, 3);
    is(5, 1, 2, 4);
    is(5, 100, 0, 4);
    is(6, std::numeric_limits<std::int64_t>::max(), 6, 8);
    is(8, 1, 6, 8);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(same_rows_as_comparing_all),
        cmocka_unit_test(none_asked_or_none_there),
        cmocka_unit_test(rows_beyond_measure),
        cmocka_unit_test(repeats_have_an_original),
        cmocka_unit_test(windows_count_originals_and_end_with_the_clip),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
