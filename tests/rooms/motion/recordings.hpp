// SPDX-License-Identifier: BSD-3-Clause
// Motions for the tests of periods, cycles and recordings.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "../assertions.hpp"
#include "base/random.hpp"
#include "motion/recording/analyze.hpp"

namespace motion_testing {

using stltsa::Matrix;
using stltsa::Random;
using namespace stltsa::motion;

inline constexpr double fps = 30;
inline constexpr std::int64_t columns = 9;

/// Appends rows to a recording, so that each motion begins where the one before ended.
class Recorder {
  public:
    /// `seconds` of cycles of `period` seconds in three columns from `first` on. `speed_up` times
    /// shorter cycles at the end.
    Recorder& cycles(double seconds, double period, std::int64_t first, double speed_up = 1) {
        double phase = 0;
        for (double t = 0; t < seconds; t += 1 / fps) {
            phase += 2 * std::numbers::pi / fps / period * (1 + (speed_up - 1) * t / seconds);
            std::vector<double> row(columns);
            row[static_cast<std::size_t>(first)] = 1 - std::cos(phase);
            row[static_cast<std::size_t>(first) + 1] = std::sin(phase);
            row[static_cast<std::size_t>(first) + 2] = 0.3 * std::sin(2 * phase + 1) - 0.25;
            rows_.push_back(row);
        }
        return *this;
    }

    /// Away and back in one column.
    Recorder& action(double seconds, std::int64_t column, double size = 1) {
        for (double t = 0; t < seconds; t += 1 / fps) {
            std::vector<double> row(columns);
            const double turn = 2 * std::numbers::pi * t / seconds;
            row[static_cast<std::size_t>(column)] = size * (1 - std::cos(turn));
            row[static_cast<std::size_t>((column + 1) % columns)] =
                size * 0.5 * std::pow(std::sin(turn / 2), 4);
            rows_.push_back(row);
        }
        return *this;
    }

    Recorder& rest(double seconds) {
        for (double t = 0; t < seconds; t += 1 / fps)
            rows_.emplace_back(columns);
        return *this;
    }

    Matrix samples(double noise = 0.003, std::uint64_t seed = 1) const {
        Random random(seed);
        Matrix x(static_cast<std::int64_t>(rows_.size()), columns);
        for (std::int64_t i = 0; i < x.rows(); ++i)
            for (std::int64_t c = 0; c < columns; ++c)
                x(i, c) = rows_[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)] +
                          noise * random.symmetric();
        return x;
    }

  private:
    std::vector<std::vector<double>> rows_;
};

inline Recording answer(const Matrix& samples) {
    return analyze(samples.view(), fps, {});
}

/// The kinds of the segments, without the rests.
inline std::vector<SegmentKind> moving_kinds(const Recording& found) {
    std::vector<SegmentKind> kinds;
    for (const Segment& segment : found.segments)
        if (segment.kind != SegmentKind::rest)
            kinds.push_back(segment.kind);
    return kinds;
}

/// Segments and units cover the samples.
inline void check_cover(const Recording& found, const Matrix& samples) {
    const auto check = [&](const auto& list) {
        double at = 0;
        for (const auto& one : list) {
            ASSERT_NEAR(one.begin, at, 0);
            assert_true(one.end > one.begin);
            at = one.end;
        }
        ASSERT_NEAR(at, static_cast<double>(samples.rows()), 0);
    };
    check(found.segments);
    check(found.units);
}

/// Pictures show the coordinate of every cycle: it swings, as high in all segments, and so does its
/// partner.
inline void check_curves(const Recording& found) {
    for (const Cycle& cycle : found.cycles)
        for (std::int64_t column = 0; column < 2; ++column) {
            double low = 1e9, high = -1e9;
            for (auto i = static_cast<std::int64_t>(cycle.begin) + 1;
                 static_cast<double>(i) < cycle.end; ++i) {
                low = std::min(low, found.curve.coords(i, column));
                high = std::max(high, found.curve.coords(i, column));
            }
            assert_true(high - low > 0.5 && high - low < 2);
        }
}

} // namespace motion_testing
