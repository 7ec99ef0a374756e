// SPDX-License-Identifier: BSD-3-Clause
// Compares the nearest rows and segments with a search over all pairs, and tests the timeline.
#include <numeric>

#include "linalg/simd.hpp"
#include "ltsa/mapping/timeline.hpp"
#include "ltsa/search/nearest_rows.hpp"
#include "ltsa/testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::ltsa::Candidate;
using stltsa::ltsa::NearestRows;
using stltsa::ltsa::NearSegment;
using stltsa::ltsa::RowRange;
using stltsa::ltsa::Segment;
using stltsa::ltsa::Timeline;

/// A wandering curve, like motion; every seventh row equals an earlier one.
Matrix curve(std::int64_t rows, std::int64_t cols, std::uint64_t seed) {
    stltsa::Random random(seed);
    Matrix x(rows, cols);
    for (std::int64_t r = 0; r < rows; ++r)
        for (std::int64_t c = 0; c < cols; ++c)
            x(r, c) =
                r % 7 == 6 ? x(r / 2, c) : (r > 0 ? x(r - 1, c) : 1000) + 0.1 * random.symmetric();
    return x;
}

std::vector<std::int32_t> every(std::int64_t rows, std::int64_t step) {
    std::vector<std::int32_t> result;
    for (std::int64_t r = 0; r < rows; r += step)
        result.push_back(static_cast<std::int32_t>(r));
    return result;
}

/// These rows, each separately.
std::vector<Segment> alone(const std::vector<std::int32_t>& rows) {
    std::vector<Segment> segments;
    for (const std::int32_t row : rows)
        segments.push_back({row, row});
    return segments;
}

/// From each row to the next, except every fifth.
std::vector<Segment> chained(const std::vector<std::int32_t>& rows) {
    std::vector<Segment> segments = alone(rows);
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
        if (i % 5 != 4)
            segments[i].next = rows[i + 1];
    return segments;
}

/// The nearest rows by sorting all allowed rows.
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
    const NearestRows nearest(x.view(), chained(rows));
    assert_true(nearest.rows() == rows);
    stltsa::Random random(99);
    std::vector<double> query(static_cast<std::size_t>(x.cols()));
    for (std::int64_t q = 0; q < x.rows(); q += 1 + x.rows() / 40) {
        // A row, a point near one, and a distant point.
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

/// The squared distance from a segment: the least of 1000 points on it.
double sampled_distance(ConstMatrixView x, const double* query, Segment segment) {
    double least = std::numeric_limits<double>::infinity();
    std::vector<double> point(static_cast<std::size_t>(x.cols));
    for (int i = 0; i <= 1000; ++i) {
        for (std::int64_t c = 0; c < x.cols; ++c)
            point[static_cast<std::size_t>(c)] =
                x(segment.row, c) + i / 1000.0 * (x(segment.next, c) - x(segment.row, c));
        least = std::min(least, stltsa::squared_distance(query, point.data(), x.cols));
    }
    return least;
}

/// The point at the returned share has the returned distance, and no sampled point is nearer.
void assert_nearest_point(ConstMatrixView x, const double* query, const NearSegment& found) {
    std::vector<double> point(static_cast<std::size_t>(x.cols));
    const auto [row, next] = found.segment;
    assert_true(found.share >= 0 && found.share <= 1);
    for (std::int64_t c = 0; c < x.cols; ++c)
        point[static_cast<std::size_t>(c)] = x(row, c) + found.share * (x(next, c) - x(row, c));
    const double step = stltsa::squared_distance(x.row(row), x.row(next), x.cols);
    ASSERT_NEAR(stltsa::squared_distance(query, point.data(), x.cols), found.distance,
                1e-12 * (1 + found.distance));
    const double sampled = sampled_distance(x, query, found.segment);
    assert_true(found.distance <= sampled + 1e-12 && sampled <= found.distance + 1e-6 * step);
    assert_int_equal(found.nearer_end(), found.share <= 0.5 ? row : next);
}

void assert_same(const std::vector<NearSegment>& found, const std::vector<NearSegment>& expected) {
    assert_int_equal(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        assert_int_equal(found[i].segment.row, expected[i].segment.row);
        assert_int_equal(found[i].segment.next, expected[i].segment.next);
        assert_true(found[i].distance == expected[i].distance &&
                    found[i].share == expected[i].share);
    }
}

/// Repetitions of a loop, each a little different: many segments are nearly as near as the nearest.
Matrix repetitions(std::int64_t rows, std::int64_t cols, double noise) {
    stltsa::Random random(4);
    Matrix x(rows, cols);
    double size = 1;
    for (std::int64_t r = 0; r < rows; ++r) {
        size += 0.02 * random.symmetric();
        for (std::int64_t c = 0; c < cols; ++c)
            x(r, c) = size * std::cos(0.9 * static_cast<double>(r) + static_cast<double>(c)) +
                      noise * random.symmetric();
    }
    return x;
}

void compare_segments(const Matrix& x) {
    const std::vector<Segment> segments = chained(every(x.rows(), 2));
    const NearestRows nearest(x.view(), segments);
    const auto count = static_cast<std::int64_t>(segments.size());
    stltsa::Random random(3);
    std::vector<double> query(static_cast<std::size_t>(x.cols()));
    for (std::int64_t q = 0; q < x.rows(); q += 23) {
        const double off = q % 3 == 0 ? 0.05 : q % 3 == 1 ? 0.5 : 3;
        for (std::size_t c = 0; c < query.size(); ++c)
            query[c] = x.row(q)[c] + off * random.symmetric();
        const auto all = nearest.nearest_segments(query.data(), 2 * count);
        assert_int_equal(all.size(), count);
        assert_true(std::is_sorted(all.begin(), all.end()));
        for (const NearSegment& found : all)
            assert_nearest_point(x.view(), query.data(), found);
        for (const std::size_t few : {1u, 4u, 40u})
            assert_same(nearest.nearest_segments(query.data(), static_cast<std::int64_t>(few)),
                        {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(few)});
        assert_same(nearest.nearest_segments_within(query.data(), count, {}), all);
    }
}

/// With fewer and with more columns than a search looks at first.
void nearest_segments_of_all(void**) {
    for (const std::int64_t cols : {2, 7, 20}) {
        compare_segments(curve(700, cols, 8));
        compare_segments(repetitions(700, cols, 0.01));
        compare_segments(repetitions(700, cols, 0.3));
    }
}

/// A segment from one side of the query to the other, across the directions in which rows vary: at
/// its middle it is much nearer than both ends are.
void a_segment_across_the_directions(void**) {
    stltsa::Random random(6);
    Matrix x(203, 9);
    for (std::int64_t r = 0; r < x.rows(); ++r)
        for (std::int64_t c = 0; c < 7; ++c)
            x(r, c) = r < 200 ? 20 + 10 * random.symmetric() : 20;
    x(200, 8) = 0.1;
    x(201, 7) = 1;
    x(202, 7) = -1;
    std::vector<Segment> segments = alone(every(x.rows(), 1));
    segments[201].next = 202;
    const NearestRows nearest(x.view(), segments);
    const double query[] = {20, 20, 20, 20, 20, 20, 20, 0, 0};
    const auto found = nearest.nearest_segments(query, 1);
    assert_int_equal(found.front().segment.row, 201);
    ASSERT_NEAR(found.front().share, 0.5, 1e-12);
}

void segments_end_with_their_range(void**) {
    Matrix x(5, 1);
    for (std::int64_t r = 0; r < 5; ++r)
        x(r, 0) = static_cast<double>(r);
    const NearestRows nearest(x.view(), {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 4}});
    const double query = 2.6;
    const auto found = nearest.nearest_segments_within(&query, 9, {0, 3});
    assert_int_equal(found.size(), 3);
    for (std::size_t i = 0; i < 2; ++i) // [1, 2] and [2], both 0.6 away
        ASSERT_NEAR(found[i].distance, 0.36, 1e-12);
    assert_true(found[1].segment.row == 2 && found[1].segment.next == 2);
    const auto inside = nearest.nearest_segments_within(&query, 1, {2, 4});
    assert_true(inside[0].segment.row == 2 && inside[0].segment.next == 3);
    ASSERT_NEAR(inside[0].share, 0.6, 1e-12);
    assert_int_equal(inside[0].nearer_end(), 3);
    assert_true(nearest.nearest_segments_within(&query, 1, {3, 3}).empty());
    assert_true(nearest.nearest_segments(&query, 0).empty());
}

void no_rows_requested_or_indexed(void**) {
    const Matrix x = curve(50, 4, 1);
    const NearestRows nearest(x.view(), alone(every(50, 1)));
    const NearestRows empty(x.view(), {});
    assert_true(nearest.nearest(x.row(3), 0).empty());
    assert_true(nearest.nearest_within(x.row(3), 0, {0, 9}).empty());
    assert_true(empty.nearest(x.row(3), 5).empty());
    assert_true(empty.nearest_within(x.row(3), 5, {0, 9}).empty());
    assert_true(nearest.contains(49) && !nearest.contains(50) && !empty.contains(0));
}

/// Squares that overflow: all rows are infinitely far, and the first ones are the nearest.
void infinite_distances(void**) {
    Matrix x = lattice(100, 3, 2);
    for (std::int64_t i = 0; i < 300; ++i)
        x.data()[i] *= 1e200;
    const NearestRows nearest(x.view(), chained(every(100, 1)));
    const double query[] = {3e200, 3e200, 3e200};
    const auto found = nearest.nearest(query, 4);
    assert_int_equal(found.size(), 4);
    for (const NearSegment& segment : nearest.nearest_segments(query, 4))
        assert_true(std::isinf(segment.distance) && segment.share == 0);
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

/// A caller's frames may become NaN while the tree is built; they cannot be sorted.
void frames_that_are_nan_are_refused(void**) {
    const Matrix x = changed(noise(100, 3), [](double) { return NAN; });
    std::vector<stltsa::ltsa::Segment> rows;
    for (std::int32_t r = 0; r < x.rows(); ++r)
        rows.push_back({r, r});
    try {
        const NearestRows tree(x.view(), rows);
        assert_true(false);
    } catch (const stltsa::Error& error) {
        assert_true(error.status() == stltsa::Status::not_finite);
    }
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
        cmocka_unit_test(nearest_segments_of_all),
        cmocka_unit_test(a_segment_across_the_directions),
        cmocka_unit_test(segments_end_with_their_range),
        cmocka_unit_test(no_rows_requested_or_indexed),
        cmocka_unit_test(infinite_distances),
        cmocka_unit_test(frames_that_are_nan_are_refused),
        cmocka_unit_test(repeats_have_an_original),
        cmocka_unit_test(windows_count_originals_and_end_with_the_clip),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
