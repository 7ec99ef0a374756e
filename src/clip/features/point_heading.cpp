// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/point_heading.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include "base/checkpoint.hpp"

namespace stltsa::clip {
namespace {

/// A pair whose length hardly changes has the weight of one that changes by this share of the size.
constexpr double steadiest = 1e-3;
/// Each point is paired with so many others at most, in so many frames, so that the cost is linear.
constexpr std::size_t most_partners = 64;
constexpr std::int64_t most_compared = 200;
/// Below this share of its median, the length of a match gives no heading, nor does the size of a
/// shape say how the body is built.
constexpr double least_match = 0.3;
/// Smallest share of the variance across the plane in which the points spread most.
constexpr double least_depth = 1e-3;

/// A vector in the horizontal plane; of length 1, a turn.
using Flat = std::complex<double>;
using FlatShape = std::vector<Flat>;

double norm(const FlatShape& shape) {
    double sum = 0;
    for (const Flat point : shape)
        sum += std::norm(point);
    return sum;
}

/// Procrustes: its direction is the turn that brings a shape closest to the reference.
Flat match(const FlatShape& shape, const FlatShape& reference) {
    Flat sum;
    for (std::size_t p = 0; p < shape.size(); ++p)
        sum += reference[p] * std::conj(shape[p]);
    return sum;
}

class Shapes {
  public:
    Shapes(Matrix& points, const std::vector<std::int64_t>& chosen, Axis up)
        : points_(points), chosen_(chosen), first_(static_cast<std::int64_t>(up) % 3),
          second_((static_cast<std::int64_t>(up) + 1) % 3) {}

    std::int64_t frames() const { return points_.rows(); }

    FlatShape shape(std::int64_t frame) const {
        checkpoint(std::ssize(chosen_));
        FlatShape points;
        points.reserve(chosen_.size());
        for (const std::int64_t p : chosen_)
            points.emplace_back(points_(frame, 3 * p + first_), points_(frame, 3 * p + second_));
        return points;
    }

    void turn(std::int64_t frame, Flat turn) {
        const FlatShape from = shape(frame);
        for (std::size_t k = 0; k < from.size(); ++k) {
            const Flat to = from[k] * turn;
            points_(frame, 3 * chosen_[k] + first_) = to.real();
            points_(frame, 3 * chosen_[k] + second_) = to.imag();
        }
    }

    /// Whether the horizontal spread is more than a line, measured by the spread in space.
    bool have_heading(Axis up) const {
        double aa = 0, ab = 0, bb = 0, height = 0;
        for (std::int64_t i = 0; i < frames(); ++i) {
            const FlatShape points = shape(i);
            for (std::size_t k = 0; k < points.size(); ++k) {
                const double a = points[k].real(), b = points[k].imag();
                const double h = points_(i, 3 * chosen_[k] + static_cast<std::int64_t>(up) - 1);
                aa += a * a, ab += a * b, bb += b * b, height += h * h;
            }
        }
        const double smaller = (aa + bb) / 2 - std::hypot((aa - bb) / 2, ab);
        return smaller > least_depth * (aa + bb + height);
    }

  private:
    Matrix& points_;
    const std::vector<std::int64_t>& chosen_;
    std::int64_t first_, second_; ///< the horizontal axes, so that (first, second, up) is even
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// The turn of a match, or the one before it if the match is too short to have one.
Flat turn_of(Flat match, double least, Flat before) {
    return std::abs(match) > least ? match / std::abs(match) : before;
}

/// Two points, and how much the direction from one to the other says about the heading.
struct Link {
    std::size_t one = 0, other = 0;
    double weight = 0;
};

/// Frames that tell about the whole recording, in equal steps. Those in which the points are nearly
/// above each other are left out: they say nothing about which lengths the body keeps.
std::vector<FlatShape> some_frames(const Shapes& shapes) {
    const std::int64_t step = 1 + (shapes.frames() - 1) / most_compared;
    std::vector<FlatShape> some;
    for (std::int64_t i = 0; i < shapes.frames(); i += step)
        some.push_back(shapes.shape(i));
    std::vector<double> sizes;
    std::ranges::transform(some, std::back_inserter(sizes), norm);
    const double least = least_match * least_match * median(sizes);
    std::erase_if(some, [least](const FlatShape& shape) { return norm(shape) < least; });
    return some;
}

Link weighed(std::size_t one, std::size_t other, const std::vector<FlatShape>& frames,
             double least) {
    double sum = 0, squares = 0;
    for (const FlatShape& frame : frames) {
        const double square = std::norm(frame[other] - frame[one]);
        sum += std::sqrt(square);
        squares += square;
    }
    const auto count = static_cast<double>(frames.size());
    const double variance = squares / count - sum * sum / (count * count);
    return {one, other, least / (least + variance)};
}

/// Pairs of points, each weighted by the inverse variance of its horizontal length, which does not
/// depend on the heading. Legs that swing against each other change the lengths between them, so
/// their swing does not turn the body. With equal weights (the usual Procrustes match) it would.
std::vector<Link> links_of(const std::vector<FlatShape>& frames) {
    const std::size_t count = frames.front().size();
    const std::size_t step = 1 + (count - 2) / most_partners;
    double size = 0;
    for (const FlatShape& frame : frames)
        size += norm(frame) / static_cast<double>(count * frames.size());
    std::vector<Link> links;
    for (std::size_t p = 0; p < count; ++p)
        for (std::size_t q = p + 1; q < count; q += step) {
            checkpoint(std::ssize(frames));
            links.push_back(weighed(p, q, frames, steadiest * steadiest * size));
        }
    return links;
}

/// What to match points with, so that the sum over points is the weighted sum over pairs.
FlatShape weighted(const std::vector<Link>& links, const FlatShape& shape) {
    FlatShape sum(shape.size());
    for (const Link& link : links) {
        const Flat apart = link.weight * (shape[link.other] - shape[link.one]);
        sum[link.other] += apart;
        sum[link.one] -= apart;
    }
    return sum;
}

/// The shape that the frames match best when each is turned to it: the first eigenvector of the
/// sum of x x* W over the frames x, where W weights pairs (Kent 1994), by power iteration.
FlatShape mean_shape(const std::vector<FlatShape>& frames, const std::vector<Link>& links) {
    constexpr int most_rounds = 100;
    constexpr double same = 1 - 1e-12;
    FlatShape mean = *std::ranges::max_element(frames, {}, norm);
    double like = 0;
    for (int round = 0; round < most_rounds && like < same; ++round) {
        const FlatShape reference = weighted(links, mean);
        FlatShape next(mean.size());
        for (const FlatShape& frame : frames) {
            checkpoint(std::ssize(frame));
            const Flat turn = match(frame, reference);
            for (std::size_t p = 0; p < next.size(); ++p)
                next[p] += turn * frame[p];
        }
        const double length = std::sqrt(norm(next));
        if (!(length > 0))
            break;
        like = std::abs(match(mean, next)) / (length * std::sqrt(norm(mean)));
        for (std::size_t p = 0; p < next.size(); ++p)
            mean[p] = next[p] / length;
    }
    return mean;
}

/// The shape in a heading of its own: from its first points to its last ones. Any other fixed
/// direction would do.
FlatShape with_own_heading(FlatShape shape) {
    Flat sum;
    for (std::size_t p = 0; p < shape.size(); ++p)
        sum += static_cast<double>(p) * shape[p]; // their mean is at the origin
    const Flat turn = turn_of(std::conj(sum), 0, {1, 0});
    for (Flat& point : shape)
        point *= turn;
    return shape;
}

} // namespace

bool remove_heading(Matrix& points, const std::vector<std::int64_t>& chosen, Axis up) {
    Shapes shapes(points, chosen, up);
    if (!shapes.have_heading(up))
        return false;
    const std::vector<FlatShape> some = some_frames(shapes);
    const std::vector<Link> links = links_of(some);
    const FlatShape reference = weighted(links, with_own_heading(mean_shape(some, links)));
    std::vector<Flat> matches;
    std::vector<double> lengths;
    for (std::int64_t i = 0; i < shapes.frames(); ++i) {
        matches.push_back(match(shapes.shape(i), reference));
        lengths.push_back(std::abs(matches.back()));
    }
    const double least = least_match * median(std::move(lengths));
    Flat turn{1, 0};
    for (std::int64_t i = 0; i < shapes.frames(); ++i) {
        turn = turn_of(matches[static_cast<std::size_t>(i)], least, turn);
        shapes.turn(i, turn);
    }
    return true;
}

double turned_range(const Matrix& points, const Matrix& turned,
                    const std::vector<std::int64_t>& chosen, Axis up) {
    Matrix from = copied(points.view()), to = copied(turned.view());
    const Shapes before(from, chosen, up), after(to, chosen, up);
    double angle = 0, least = 0, most = 0;
    for (std::int64_t i = 0; i < before.frames(); ++i) {
        double next = std::arg(match(before.shape(i), after.shape(i)));
        next += 2 * std::numbers::pi * std::round((angle - next) / (2 * std::numbers::pi));
        angle = next;
        least = i == 0 ? next : std::min(least, next);
        most = i == 0 ? next : std::max(most, next);
    }
    return most - least;
}

} // namespace stltsa::clip
