// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/point_heading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "clip/features/slow_part.hpp"

namespace stltsa::clip {
namespace {

/// Seconds in which the running reference forgets a shape.
constexpr double memory_s = 0.4;
/// Seconds over which the slow angle is smoothed.
constexpr double slow_s = 1;
/// Below this share of its median length a match gives no heading.
constexpr double least_match = 0.3;
/// Smallest share of the variance across the plane in which the points spread most.
constexpr double least_depth = 1e-3;

/// A vector in the horizontal plane; of length 1, a turn.
struct Flat {
    double a = 0, b = 0;

    double length() const { return std::hypot(a, b); }
    Flat turned(Flat turn) const { return {turn.a * a - turn.b * b, turn.b * a + turn.a * b}; }
    Flat direction() const { return {a / length(), b / length()}; }
};

class Shapes {
  public:
    Shapes(Matrix& points, Axis up, PacedPoll& polls)
        : points_(points), polls_(polls), first_(static_cast<std::int64_t>(up) % 3),
          second_((static_cast<std::int64_t>(up) + 1) % 3) {}

    std::int64_t frames() const { return points_.rows(); }
    std::int64_t count() const { return points_.cols() / 3; }
    Flat at(std::int64_t frame, std::int64_t point) const {
        const double* p = points_.row(frame) + 3 * point;
        return {p[first_], p[second_]};
    }
    void turn(std::int64_t frame, Flat turn) {
        polls_.did(points_.cols());
        for (std::int64_t p = 0; p < count(); ++p) {
            const Flat to = at(frame, p).turned(turn);
            points_(frame, 3 * p + first_) = to.a;
            points_(frame, 3 * p + second_) = to.b;
        }
    }
    void turn(const std::vector<Flat>& turns) {
        for (std::int64_t i = 0; i < frames(); ++i)
            turn(i, turns[static_cast<std::size_t>(i)]);
    }

    std::vector<Flat> mean() const {
        std::vector<Flat> sum(static_cast<std::size_t>(count()));
        for (std::int64_t i = 0; i < frames(); ++i) {
            polls_.did(points_.cols());
            for (std::size_t p = 0; p < sum.size(); ++p) {
                const Flat q = at(i, static_cast<std::int64_t>(p));
                sum[p].a += q.a / static_cast<double>(frames());
                sum[p].b += q.b / static_cast<double>(frames());
            }
        }
        return sum;
    }

    /// Procrustes: its direction is the turn that brings the frame closest to the reference.
    Flat match(std::int64_t frame, const std::vector<Flat>& reference) const {
        Flat sum;
        polls_.did(points_.cols());
        for (std::size_t p = 0; p < reference.size(); ++p) {
            const Flat q = at(frame, static_cast<std::int64_t>(p));
            sum.a += q.a * reference[p].a + q.b * reference[p].b;
            sum.b += q.a * reference[p].b - q.b * reference[p].a;
        }
        return sum;
    }

    /// Whether the horizontal spread is more than a line, measured by the spread in space.
    bool have_heading(Axis up) const {
        double aa = 0, ab = 0, bb = 0, height = 0;
        for (std::int64_t i = 0; i < frames(); ++i) {
            polls_.did(points_.cols());
            for (std::int64_t p = 0; p < count(); ++p) {
                const Flat q = at(i, p);
                const double h = points_(i, 3 * p + static_cast<std::int64_t>(up) - 1);
                aa += q.a * q.a, ab += q.a * q.b, bb += q.b * q.b, height += h * h;
            }
        }
        const double smaller = (aa + bb) / 2 - std::hypot((aa - bb) / 2, ab);
        return smaller > least_depth * (aa + bb + height);
    }

  private:
    Matrix& points_;
    PacedPoll& polls_;
    std::int64_t first_, second_; ///< the horizontal axes, so that (first, second, up) is even
};

double median_length(std::vector<Flat> matches) {
    const auto middle = matches.begin() + std::ssize(matches) / 2;
    std::nth_element(matches.begin(), middle, matches.end(),
                     [](Flat x, Flat y) { return x.length() < y.length(); });
    return middle->length();
}

/// The turn of a match, or the one before it if the match is too short to have one.
Flat turn_of(Flat match, double least, Flat before) {
    return match.length() > least ? match.direction() : before;
}

/// Matches of all frames to the mean of those before, turned; a match is weighted by its age.
/// `turns`: the turns that were made.
std::vector<Flat> follow(const Shapes& shapes, double fps, double least, std::vector<Flat>& turns) {
    const double rate = -std::expm1(-1 / (memory_s * fps));
    std::vector<Flat> matches;
    std::vector<Flat> reference(static_cast<std::size_t>(shapes.count()));
    for (std::size_t p = 0; p < reference.size(); ++p)
        reference[p] = shapes.at(0, static_cast<std::int64_t>(p));
    Flat turn{1, 0};
    turns.clear();
    for (std::int64_t i = 0; i < shapes.frames(); ++i) {
        matches.push_back(shapes.match(i, reference));
        turn = turn_of(matches.back(), least, turn);
        turns.push_back(turn);
        for (std::size_t p = 0; p < reference.size(); ++p) {
            const Flat q = shapes.at(i, static_cast<std::int64_t>(p)).turned(turn);
            reference[p].a += rate * (q.a - reference[p].a);
            reference[p].b += rate * (q.b - reference[p].b);
        }
    }
    return matches;
}

/// Quick turns go; the reference drifts, so that a slow turn is left.
void remove_quick_turns(Shapes& shapes, double fps) {
    std::vector<Flat> turns;
    const std::vector<Flat> matches = follow(shapes, fps, 0, turns);
    follow(shapes, fps, least_match * median_length(matches), turns);
    shapes.turn(turns);
}

void remove_slow_turn(Shapes& shapes, double fps) {
    const std::vector<Flat> reference = shapes.mean();
    std::vector<Flat> matches;
    for (std::int64_t i = 0; i < shapes.frames(); ++i)
        matches.push_back(shapes.match(i, reference));
    const double least = least_match * median_length(matches);
    Matrix angles = Matrix::unset(shapes.frames(), 2);
    Flat turn{1, 0};
    for (std::int64_t i = 0; i < shapes.frames(); ++i) {
        turn = turn_of(matches[static_cast<std::size_t>(i)], least, turn);
        angles(i, 0) = turn.a;
        angles(i, 1) = turn.b;
    }
    const Matrix slow = slow_part(angles, slow_s * fps);
    for (std::int64_t i = 0; i < shapes.frames(); ++i)
        shapes.turn(i, turn_of({slow(i, 0), slow(i, 1)}, 0, {1, 0}));
}

/// Turns the whole recording so that its heading is given by its shape: the direction from the
/// first points of the list to the last ones. Any fixed direction would do.
void set_heading(Shapes& shapes) {
    const std::vector<Flat> mean = shapes.mean();
    Flat sum;
    for (std::size_t p = 0; p < mean.size(); ++p) {
        const double place = static_cast<double>(p) - static_cast<double>(mean.size() - 1) / 2;
        sum.a += place * mean[p].a;
        sum.b -= place * mean[p].b;
    }
    const Flat turn = turn_of(sum, 0, {1, 0});
    for (std::int64_t i = 0; i < shapes.frames(); ++i)
        shapes.turn(i, turn);
}

} // namespace

bool remove_heading(Matrix& points, Axis up, double fps, PacedPoll& polls) {
    Shapes shapes(points, up, polls);
    if (!shapes.have_heading(up))
        return false;
    remove_quick_turns(shapes, fps);
    remove_slow_turn(shapes, fps);
    remove_slow_turn(shapes, fps);
    set_heading(shapes);
    return true;
}

double turned_range(const Matrix& points, const Matrix& turned, Axis up, PacedPoll& polls) {
    Matrix from = copied(points.view()), to = copied(turned.view());
    const Shapes before(from, up, polls), after(to, up, polls);
    double angle = 0, least = 0, most = 0;
    for (std::int64_t i = 0; i < before.frames(); ++i) {
        std::vector<Flat> reference;
        for (std::int64_t p = 0; p < after.count(); ++p)
            reference.push_back(after.at(i, p));
        const Flat match = before.match(i, reference);
        double next = std::atan2(match.b, match.a);
        next += 2 * std::numbers::pi * std::round((angle - next) / (2 * std::numbers::pi));
        angle = next;
        least = i == 0 ? next : std::min(least, next);
        most = i == 0 ? next : std::max(most, next);
    }
    return most - least;
}

} // namespace stltsa::clip
