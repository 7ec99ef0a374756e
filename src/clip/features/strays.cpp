// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/strays.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/checkpoint.hpp"
#include "base/numbers.hpp"
#include "clip/clip.hpp"
#include "linalg/simd.hpp"

namespace stltsa::clip {
namespace {

/// A stray point is farther from the straight line between the frames beside it than this share of
/// the body's size, and than the largest acceleration of a limb takes it: sizes per second squared.
/// A size is about 0.4 m; punches and kicks reach 200 m/s^2, so about half as much as here.
constexpr double least_away = 0.1;
constexpr double most_acceleration = 1000;
constexpr std::int64_t frames_measured = 100;
/// The size of fewer points, such as those of a hand or a stick, is not that of a body.
constexpr std::int64_t min_points = 8;

double square(double x) {
    return x * x;
}

/// The points of one clip.
class Paths {
  public:
    Paths(Matrix& rows, int width, double fps)
        : rows_(rows), width_(width), fps_(fps), size_(median_size()) {}

    bool measurable() const { return size_ > 0; }
    std::int64_t count() const { return rows_.cols() / width_; }

    /// Makes the strays of the point NaN; returns their number.
    std::int64_t drop(std::int64_t point) {
        std::int64_t dropped = 0;
        for (std::int64_t i = 1; i < rows_.rows(); ++i) {
            checkpoint(width_);
            if (is_missing(at(i - 1, point), width_) || is_missing(at(i, point), width_))
                continue;
            const std::int64_t end = end_of_strays(i, point);
            dropped += end - i;
            for (std::int64_t stray = i; stray < end; ++stray)
                std::fill_n(at(stray, point), width_, none);
        }
        return dropped;
    }

  private:
    double* at(std::int64_t frame, std::int64_t point) { return rows_.row(frame) + width_ * point; }

    /// Root mean square distance of the points from their mean, in the median frame.
    double median_size() {
        std::vector<double> sizes;
        const std::int64_t step = 1 + (rows_.rows() - 1) / frames_measured;
        for (std::int64_t i = 0; i < rows_.rows(); i += step) {
            double squares = 0, points = 0;
            std::vector<double> sum(static_cast<std::size_t>(width_));
            for (std::int64_t p = 0; p < count(); ++p) {
                const double* point = at(i, p);
                if (is_missing(point, width_))
                    continue;
                ++points;
                for (int c = 0; c < width_; ++c) {
                    sum[static_cast<std::size_t>(c)] += point[c];
                    squares += point[c] * point[c];
                }
            }
            for (const double each : sum)
                squares -= each * each / points;
            if (points >= static_cast<double>(min_points) && squares > 0)
                sizes.push_back(std::sqrt(squares / points));
        }
        if (sizes.empty())
            return 0;
        const auto middle = sizes.begin() + std::ssize(sizes) / 2;
        std::ranges::nth_element(sizes, middle);
        return *middle;
    }

    double distance(std::int64_t frame, std::int64_t other, std::int64_t point) {
        return std::sqrt(squared_distance(at(frame, point), at(other, point), width_));
    }

    /// The frame at which the point that left its path at `first` is back on it; `first`: it is no
    /// stray.
    std::int64_t end_of_strays(std::int64_t first, std::int64_t point) {
        const std::int64_t before = first - 1;
        // A stray moves at least half of `away` in its first frame: the line rises by no more.
        if (distance(before, first, point) <= least_away / 2 * size_)
            return first;
        for (std::int64_t end = first + 1; end < rows_.rows(); ++end) {
            const double half = static_cast<double>(end - before) / (2 * fps_);
            if (2 * half > longest_stray_s || is_missing(at(end, point), width_))
                break;
            // Farther than the frames beside it are apart, or one of those is the stray.
            const double away =
                std::max(std::max(least_away, most_acceleration * half * half / 2) * size_,
                         distance(before, end, point));
            bool all = true;
            for (std::int64_t i = first; i < end && all; ++i)
                all = is_off({before, i, end}, point, away);
            if (all)
                return end;
        }
        return first;
    }

    /// A frame between two others.
    struct Between {
        std::int64_t before, frame, end;
    };

    /// One coordinate of the way from the straight line between the frames beside it.
    double off_line(const Between& frames, std::int64_t point, int c) {
        const double share = static_cast<double>(frames.frame - frames.before) /
                             static_cast<double>(frames.end - frames.before);
        return at(frames.frame, point)[c] - (1 - share) * at(frames.before, point)[c] -
               share * at(frames.end, point)[c];
    }

    /// Whether the point is that far off the line, and still is if the mean of the other points is
    /// subtracted: the whole body may jump.
    bool is_off(const Between& frames, std::int64_t point, double away) {
        double own = 0, alone = 0;
        for (int c = 0; c < width_; ++c)
            own += square(off_line(frames, point, c));
        if (!(own > square(away)))
            return false;
        checkpoint(rows_.cols());
        for (int c = 0; c < width_; ++c) {
            double others = 0, known = 0;
            for (std::int64_t p = 0; p < count(); ++p)
                if (const double other = off_line(frames, p, c);
                    p != point && std::isfinite(other)) {
                    others += other;
                    ++known;
                }
            alone += square(off_line(frames, point, c) - others / std::max(1.0, known));
        }
        return alone > square(away);
    }

    Matrix& rows_;
    int width_;
    double fps_;
    double size_;
};

} // namespace

std::vector<std::int64_t> drop_strays(Matrix& rows, int width, double fps) {
    if (rows.cols() / width < min_points || !(fps > 0))
        return {};
    Paths paths(rows, width, fps);
    std::vector<std::int64_t> frames;
    for (std::int64_t point = 0; paths.measurable() && point < paths.count(); ++point)
        frames.push_back(paths.drop(point));
    return frames;
}

} // namespace stltsa::clip
