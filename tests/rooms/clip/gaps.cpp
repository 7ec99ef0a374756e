// SPDX-License-Identifier: BSD-3-Clause
// Gaps: which points take part, in which frames the body is there, and what fills the rest.
#include "checkpoints.hpp"
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "clip/features/gaps.hpp"
#include "clip/features/near_groups.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

void gaps_are_filled_linearly(void**) {
    Matrix all(10, 12);
    for (std::int64_t i = 0; i < 10; ++i)
        for (std::int64_t c = 0; c < 12; ++c)
            all(i, c) = static_cast<double>(c) + 2 * static_cast<double>(i) + 1;
    const Matrix whole = copied(all.view());
    const auto lose = [&](std::int64_t i, std::int64_t p, double value) {
        std::fill_n(all.row(i) + 3 * p, 3, value);
    };
    for (const std::int64_t i : {2, 3, 4, 8})
        lose(i, 0, 0);
    all(5, 3 + 1) = gap; // a point without one coordinate is missing
    for (const std::int64_t i : {0, 1, 9})
        lose(i, 2, gap);
    for (std::int64_t i = 0; i < 6; ++i)
        lose(i, 3, 0);
    const Gaps gaps = fill_gaps(all, 3, GapRule::fill, 0);
    assert_true(gaps.seen == (std::vector<std::int64_t>{0, 1, 2}) && gaps.filled == gaps.seen);
    assert_true(gaps.dropped == std::vector<std::int64_t>{3} && gaps.frames == 8);
    for (std::int64_t i = 0; i < 10; ++i)
        for (std::int64_t c = 0; c < 12; ++c) // at the ends, a point goes on with the others
            ASSERT_NEAR(all(i, c), c < 9 ? whole(i, c) : 0, 1e-12);
}

/// What one of ten points does alone is not what the body does.
void the_body_stands_while_nearly_all_is_missing(void**) {
    Matrix all(30, 30);
    std::fill_n(all.data(), 30 * 30, 1.0);
    for (std::int64_t i = 10; i < 20; ++i) {
        std::fill_n(all.row(i), 3, 10.0);
        std::fill_n(all.row(i) + 3, 27, gap);
    }
    const Gaps gaps = fill_gaps(all, 3, GapRule::fill, 100);
    assert_true(gaps.filled.size() == 9 && gaps.holes.empty());
    for (std::int64_t i = 10; i < 20; ++i)
        for (std::int64_t c = 3; c < 30; ++c)
            ASSERT_NEAR(all(i, c), 1, 1e-12);
}

void half_of_the_frames_are_enough(void**) {
    for (const std::int64_t missing : {5, 6, 10}) {
        Matrix all(10, 6);
        for (std::int64_t i = 0; i < 10; ++i)
            all(i, 3) = 1;
        for (std::int64_t i = missing; i < 10; ++i)
            all(i, 0) = 7;
        assert_int_equal(fill_gaps(all, 3, GapRule::fill, 0).dropped.size(), missing > 5);
        assert_true(all(0, 0) == (missing > 5 ? 0 : 7));
    }
}

/// Points, of which the first `parts[k].first` points not counted yet are seen in parts[k].second.
Matrix seen_in(std::int64_t frames, const std::vector<std::pair<std::int64_t, Frames>>& parts) {
    std::int64_t points = 0, first = 0;
    for (const auto& part : parts)
        points += part.first;
    Matrix all(frames, 3 * points);
    for (const auto& [count, seen] : parts) {
        for (std::int64_t i = seen.begin; i < seen.end; ++i)
            std::fill_n(all.row(i) + 3 * first, 3 * count, 1.0);
        first += count;
    }
    return all;
}

/// What share of a point is missing counts only in frames with the body.
void frames_without_the_body_do_not_count(void**) {
    // A body crosses the picture, and one point is taken for a tail all the time.
    Matrix crossing = seen_in(1000, {{14, {500, 900}}, {1, {0, 1000}}});
    const Gaps crossed = fill_gaps(crossing, 3, GapRule::fill, 100);
    assert_true(crossed.dropped.empty() && crossed.filled.empty() && crossed.frames == 0);
    assert_true(crossed.holes == (std::vector<Frames>{{0, 500}, {900, 1000}}));
    assert_true(crossed.kept == (Frames{500, 900}) && crossing.rows() == 400);
    // Legs are seen all the time, the rest of the body comes later.
    Matrix legs = seen_in(1000, {{10, {0, 1000}}, {15, {600, 1000}}});
    const Gaps later = fill_gaps(legs, 3, GapRule::fill, 100);
    assert_true(later.seen.size() == 10 && later.dropped.size() == 15 && later.holes.empty());
    // Nor does the second of two bodies take the first away.
    Matrix two = seen_in(1000, {{20, {0, 1000}}, {22, {600, 1000}}});
    assert_true(fill_gaps(two, 3, GapRule::fill, 100).kept.count() == 1000);
}

/// Points that are there only while most others are missing have no frame in which to take part.
void points_seen_only_in_a_hole_are_dropped(void**) {
    for (const bool at_start : {false, true}) {
        const Frames early{0, 150}, late{150, 300};
        Matrix all = seen_in(300, {{4, at_start ? early : late}, {6, at_start ? late : early}});
        const Gaps gaps = fill_gaps(all, 3, GapRule::fill, 100);
        assert_true(gaps.kept == (at_start ? late : early));
        assert_true(gaps.seen == (std::vector<std::int64_t>{4, 5, 6, 7, 8, 9}));
        assert_true(gaps.dropped == (std::vector<std::int64_t>{0, 1, 2, 3}));
        assert_true(gaps.filled.empty() && gaps.frames == 0 && gaps.predicted.empty());
        assert_true(all(0, 0) == 0 && all(0, 12) == 1);
    }
}

void near_groups_are_near(void**) {
    // 250 points on a line, in another order.
    Matrix line(4, 750);
    for (std::int64_t p = 0; p < 250; ++p)
        for (std::int64_t i = 0; i < 4; ++i)
            line(i, 3 * p + 1) = static_cast<double>(p * 7 % 250);
    std::vector<std::int64_t> all(250);
    std::iota(all.begin(), all.end(), 0);
    double at = -1;
    for (const auto& set : near_groups(line, 3, all, 100)) {
        assert_true(std::ranges::is_sorted(set) && (set.size() == 62 || set.size() == 63));
        double low = 250, high = 0;
        for (const std::int64_t p : set) {
            low = std::min(low, line(0, 3 * p + 1));
            high = std::max(high, line(0, 3 * p + 1));
        }
        ASSERT_NEAR(low, at + 1, 0);
        ASSERT_NEAR(high - low + 1, static_cast<double>(set.size()), 0);
        at = high;
    }
    assert_true(near_groups(line, 3, all, 250).size() == 1);
    // Columns that are no coordinates are near those beside them.
    const auto sets = near_groups(line, 1, all, 125);
    assert_true(sets.size() == 2 && sets[0].back() == 124 && sets[1].front() == 125);
}

/// Of very many points, those nearby predict: here those of another tempo do not.
void many_points_are_predicted_from_near_ones(void**) {
    constexpr std::int64_t points_count = 2000, frames = 300;
    Matrix all(frames, 3 * points_count);
    const auto value = [](std::int64_t i, std::int64_t p, std::int64_t c) {
        const double tempo = p % 2 == 0 ? 0.1 : 0.07;
        return static_cast<double>(p % 2) * 50 + static_cast<double>(p) / 100 +
               std::sin(tempo * static_cast<double>(i) + static_cast<double>(c));
    };
    for (std::int64_t i = 0; i < frames; ++i)
        for (std::int64_t p = 0; p < points_count; ++p)
            for (std::int64_t c = 0; c < 3; ++c)
                all(i, 3 * p + c) = value(i, p, c);
    for (std::int64_t i = 0; i < 60; ++i)
        std::fill_n(all.row(i) + 3 * 1001, 3, gap);
    const Gaps gaps = fill_gaps(all, 3, GapRule::fill, 100);
    assert_true(testing::checkpoints_of([&] { predict_gaps(all, 3, gaps); }) > 10);
    for (std::int64_t i = 0; i < 60; ++i)
        for (std::int64_t c = 0; c < 3; ++c)
            ASSERT_NEAR(all(i, 3003 + c), value(i, 1001, c), 1e-2);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(gaps_are_filled_linearly),
        cmocka_unit_test(the_body_stands_while_nearly_all_is_missing),
        cmocka_unit_test(half_of_the_frames_are_enough),
        cmocka_unit_test(frames_without_the_body_do_not_count),
        cmocka_unit_test(points_seen_only_in_a_hole_are_dropped),
        cmocka_unit_test(near_groups_are_near),
        cmocka_unit_test(many_points_are_predicted_from_near_ones),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
