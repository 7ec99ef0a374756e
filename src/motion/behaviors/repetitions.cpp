// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/repetitions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "linalg/principal.hpp"
#include "linalg/simd.hpp"
#include "motion/behaviors/grouping.hpp"
#include "motion/behaviors/rests.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// A rest is slower than this share of the usual speed for this long, and once slower than that. It
/// ends where the speed rises above the latter, or above that of standing: if it lasted until the
/// former, the first step of a walk would begin 0.3 s late instead of 0.04 s (measure/clips, "two
/// walks").
constexpr double slow = 0.25;
constexpr double still = 0.15;
constexpr double shortest_rest_s = 0.3;
/// What covers less than the path of this time at the usual speed is no motion but noise.
constexpr double min_path_s = 0.2;
/// A rest away from home ends a motion only if it lasts longer than this; even then the motion may
/// go on after it, up to the second limit, since arms may be held up.
constexpr double long_rest_s = 1;
constexpr double longest_hold_s = 10;
/// Rests are in one posture if their squared distance is below this share of the extent of motions.
constexpr double same_posture = 0.6;
/// Motions are compared at so many phases, which may be this far apart.
constexpr std::int64_t phases = 24;
constexpr std::int64_t band = 7;
/// Motions whose lengths differ by more are never the same.
constexpr double most_length_ratio = 2;
constexpr double unrelated = 9;

std::vector<double> mean_pose(const Signal& signal, Rows rows) {
    return column_means(signal.poses.view().block(rows.begin, rows.count()));
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    return squared_distance(a.data(), b.data(), static_cast<std::int64_t>(a.size()));
}

/// The largest squared distance from the motion's mean pose.
double extent(const Signal& signal, Rows rows) {
    const auto mean = mean_pose(signal, rows);
    double most = 0;
    for (std::int64_t i = rows.begin; i < rows.end; ++i)
        most = std::max(most, squared_distance(signal.poses.row(i), mean.data(), signal.cols()));
    return most;
}

/// What lies between rests within the range.
void append_actions(const std::vector<Rows>& rests, Rows range, std::vector<Rows>& actions) {
    std::int64_t at = range.begin;
    const auto close = [&](std::int64_t end) {
        if (end > at)
            actions.push_back({at, end});
    };
    for (const Rows& rest : rests) {
        if (rest.end <= at || rest.begin >= range.end)
            continue;
        close(std::max(at, rest.begin));
        at = std::min(rest.end, range.end);
    }
    close(range.end);
}

/// For each rest whether the body is in the home posture.
std::vector<bool> at_home(const Signal& signal, const std::vector<Rows>& rests, double moves) {
    std::vector<std::vector<double>> poses;
    for (const Rows& rest : rests)
        poses.push_back(mean_pose(signal, rest));
    const auto near = [&](const std::vector<double>& a, const std::vector<double>& b) {
        return distance(a, b) <= same_posture * moves;
    };
    const auto n = signal.rows();
    const std::vector<double> ends[] = {mean_pose(signal, {0, 1}), mean_pose(signal, {n - 1, n})};
    std::size_t home = 0;
    double most = -1;
    // Rests are compared with a limited number of postures, which keeps the time linear.
    constexpr std::size_t most_postures = 200;
    const std::size_t stride = (rests.size() + most_postures - 1) / most_postures;
    for (std::size_t h = 0; h < rests.size(); h += std::max<std::size_t>(1, stride)) {
        double time = 0;
        for (std::size_t i = 0; i < rests.size(); ++i)
            if (near(poses[h], poses[i]))
                time += static_cast<double>(rests[i].count());
        double ends_there = 1;
        for (const auto& end : ends)
            if (near(poses[h], end))
                ++ends_there;
        time *= ends_there;
        if (time > most) {
            most = time;
            home = h;
        }
    }
    std::vector<bool> result;
    for (const auto& pose : poses)
        result.push_back(near(poses[home], pose));
    return result;
}

/// The least sum of squared distances along a path through both motions.
double warped_distance(const Matrix& a, const Matrix& b) {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<double> before(phases + 1, far), here(phases + 1, far);
    before[0] = 0;
    for (std::int64_t i = 1; i <= phases; ++i) {
        std::fill(here.begin(), here.end(), far);
        for (std::int64_t k = std::max<std::int64_t>(1, i - band); k <= std::min(phases, i + band);
             ++k) {
            const auto at = static_cast<std::size_t>(k);
            here[at] = squared_distance(a.row(i - 1), b.row(k - 1), a.cols()) +
                       std::min({before[at - 1], before[at], here[at - 1]});
        }
        before.swap(here);
    }
    return before.back() / static_cast<double>(phases);
}

Matrix shape(const Signal& signal, Rows rows) {
    const double last = static_cast<double>(rows.end - 1);
    const double first = static_cast<double>(rows.begin);
    return rows_at(signal.poses.view(), first,
                   first + (last - first) * phases / static_cast<double>(phases - 1), phases);
}

double unlikeness_of(const Matrix& a, const Matrix& b) {
    const double moves = total_variance(a.view()) + total_variance(b.view());
    return moves > 0 ? warped_distance(a, b) / moves : unrelated;
}

bool lengths_differ(Rows a, Rows b) {
    const auto [less, more] = std::minmax({a.count(), b.count()});
    return static_cast<double>(more) > most_length_ratio * static_cast<double>(less);
}

} // namespace

std::vector<Rows> find_rests(const Signal& signal) {
    std::vector<double> level;
    for (std::size_t i = 0; i < signal.speed.size(); ++i)
        level.push_back(signal.near_usual[i] > 0 ? signal.speed[i] / signal.near_usual[i] : 0);
    std::vector<Rows> rests;
    const auto moved = [&](std::int64_t begin, std::int64_t end) {
        return std::accumulate(level.begin() + begin, level.begin() + end, 0.0) >=
               min_path_s * signal.rate;
    };
    for (const Rest& rest : find_rests(level, {slow, shortest_rest_s * signal.rate, still})) {
        const Rows rows{static_cast<std::int64_t>(std::ceil(rest.begin)),
                        static_cast<std::int64_t>(std::ceil(rest.end))};
        if (std::any_of(level.begin() + rows.begin, level.begin() + rows.end,
                        [](double each) { return each < still; })) {
            if (const std::int64_t before = rests.empty() ? 0 : rests.back().end;
                moved(before, rows.begin))
                rests.push_back(rows);
            else if (rests.empty())
                rests.push_back({0, rows.end});
            else
                rests.back().end = rows.end;
        }
    }
    if (!rests.empty() && !moved(rests.back().end, signal.rows()))
        rests.back().end = signal.rows();
    return rests;
}

Pauses find_pauses(const Signal& signal, const std::vector<Rows>& rests) {
    Pauses pauses;
    if (rests.empty())
        return pauses;
    std::vector<Rows> actions;
    append_actions(rests, {0, signal.rows()}, actions);
    std::vector<double> extents;
    for (const Rows& action : actions)
        extents.push_back(extent(signal, action));
    const std::vector<bool> home = at_home(signal, rests, median(extents));
    for (std::size_t i = 0; i < rests.size(); ++i)
        if (home[i] || static_cast<double>(rests[i].count()) >= long_rest_s * signal.rate) {
            pauses.rests.push_back(rests[i]);
            pauses.home.push_back(home[i]);
        }
    return pauses;
}

std::vector<Rows> find_motions(const Signal& signal, const Pauses& pauses,
                               const std::vector<Rows>& ranges) {
    std::vector<Rows> actions;
    for (const Rows& range : ranges)
        append_actions(pauses.rests, range, actions);
    const auto holds_at = [&](std::int64_t row) { // a pause away from home begins here
        const auto rest = std::ranges::lower_bound(pauses.rests, row, {}, &Rows::begin);
        return rest != pauses.rests.end() && rest->begin == row &&
               static_cast<double>(rest->count()) < longest_hold_s * signal.rate &&
               !pauses.home[static_cast<std::size_t>(rest - pauses.rests.begin())];
    };
    std::vector<Rows> motions;
    bool open = false;
    for (const Rows& action : actions) {
        if (open && std::ranges::any_of(ranges, [&](const Rows& range) {
                return range.begin <= motions.back().begin && range.end >= action.end;
            }))
            motions.back().end = action.end;
        else
            motions.push_back(action);
        open = holds_at(action.end);
    }
    return motions;
}

double unlikeness(const Signal& signal, Rows a, Rows b) {
    return lengths_differ(a, b) ? unrelated : unlikeness_of(shape(signal, a), shape(signal, b));
}

std::vector<int> group_motions(const Signal& signal, const std::vector<Rows>& motions) {
    std::vector<Matrix> shapes;
    for (const Rows& motion : motions)
        shapes.push_back(shape(signal, motion));
    return group(static_cast<std::int64_t>(motions.size()), same_motion,
                 [&](std::int64_t i, std::int64_t k) {
                     const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
                     return lengths_differ(motions[a], motions[b])
                                ? unrelated
                                : unlikeness_of(shapes[a], shapes[b]);
                 });
}

} // namespace stltsa::motion
