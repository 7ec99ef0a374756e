// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/behaviors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/progress.hpp"
#include "linalg/gaussian.hpp"
#include "linalg/principal.hpp"
#include "linalg/simd.hpp"
#include "motion/behaviors/grouping.hpp"

namespace stltsa::motion {
namespace {

/// Segments are one behavior if the cosine of their kernel means is at least this.
constexpr double same_behavior = 0.85;
/// Assigning each moment anew: price of a change, shortest stay, rounds, and most behaviors.
constexpr double price_of_change = 10;
constexpr double shortest_stay_s = 0.8;
constexpr int rounds = 2;
constexpr std::size_t most_behaviors = 64;
/// The window of the kernel features reaches over a border from its louder side.
constexpr double most_shift_s = 0.2;
constexpr double near_s = 0.4;
constexpr double far_s = 2.5;
/// Placing each border: rate of the poses; their smoothing; how far the border may move to each
/// side; how far examples lie from borders, and from the pose they are compared with; most
/// examples; and the squared distance, as a share of the total variance, beyond which a pose is
/// like none.
constexpr double poses_per_second = 15;
constexpr double pose_smoothing_s = 0.1;
constexpr double window_s = 1.2;
constexpr double away_s = 0.5;
constexpr double skipped_s = 0.3;
constexpr std::size_t most_examples = 200;
constexpr double unlike = 0.2;
/// Places about as good as the best: the border is in their middle, since a body that stands
/// between two motions is like neither.
constexpr double about_as_good = 2;

/// A stretch of one behavior, in moments of the features or in rows.
struct Stay {
    Rows range;
    std::size_t label = 0;
};

std::vector<Stay> labeled(const KernelFeatures& features, const std::vector<std::int64_t>& borders,
                          const std::function<void()>& poll) {
    std::vector<Stay> stays;
    std::int64_t at = 0;
    for (const std::int64_t border : borders) {
        stays.push_back({{at, border}, 0});
        at = border;
    }
    stays.push_back({{at, features.count()}, 0});
    const std::vector<int> labels = group(
        static_cast<std::int64_t>(stays.size()), 1 - same_behavior,
        [&](std::int64_t i, std::int64_t k) {
            return 1 - features.likeness(stays[static_cast<std::size_t>(i)].range,
                                         stays[static_cast<std::size_t>(k)].range);
        },
        poll);
    for (std::size_t i = 0; i < stays.size(); ++i)
        stays[i].label = static_cast<std::size_t>(labels[i]);
    return stays;
}

/// The mean features of each label, one a row; rows of labels without moments are zero.
Matrix means_of(const KernelFeatures& features, const std::vector<Stay>& stays,
                std::size_t labels) {
    Matrix means(static_cast<std::int64_t>(labels), features.size());
    std::vector<double> counts(labels);
    for (const Stay& stay : stays) {
        features.add_sum(stay.range, means.row(static_cast<std::int64_t>(stay.label)));
        counts[stay.label] += static_cast<double>(stay.range.count());
    }
    for (std::size_t l = 0; l < labels; ++l)
        for (std::int64_t f = 0; f < means.cols() && counts[l] > 0; ++f)
            means(static_cast<std::int64_t>(l), f) /= counts[l];
    return means;
}

/// The cheapest sequence of labels: each moment costs its squared distance from the mean of its
/// label, and each change its price.
std::vector<Stay> assigned(const KernelFeatures& features, const Matrix& means,
                           const std::function<void()>& poll) {
    const auto n = static_cast<std::size_t>(features.count());
    const auto labels = static_cast<std::size_t>(means.rows());
    const auto least =
        static_cast<std::size_t>(std::max(1.0, std::round(shortest_stay_s * features.rate())));
    constexpr double never = std::numeric_limits<double>::infinity();
    struct End { // of the stays before a moment: the two cheapest labels and their costs
        double best = never, second = never;
        std::size_t label = 0;
    };
    std::vector<End> ends(n + 1);
    ends[0] = {-price_of_change, -price_of_change, labels};
    std::vector<std::uint32_t> begins(n * labels); // of the stay that ends after a moment
    std::vector<double> running(labels);           // sums of the costs so far
    std::vector<double> entered(labels, never);    // cheapest entry, less the sum there
    std::vector<std::uint32_t> entry(labels);
    std::vector<std::vector<double>> sums(least, std::vector<double>(labels)); // the last ones
    std::vector<double> norms;
    for (std::int64_t l = 0; l < means.rows(); ++l)
        norms.push_back(dot(means.row(l), means.row(l), means.cols()));
    std::vector<double> feature(static_cast<std::size_t>(features.size()));
    PacedPoll polls(poll);
    for (std::size_t t = 0; t < n; ++t) {
        polls.did(means.rows() * means.cols());
        sums[t % least] = running; // before moment t
        std::fill(feature.begin(), feature.end(), 0.0);
        const auto moment = static_cast<std::int64_t>(t);
        features.add_sum({moment, moment + 1}, feature.data());
        for (std::size_t l = 0; l < labels; ++l)
            running[l] += norms[l] - 2 * dot(feature.data(),
                                             means.row(static_cast<std::int64_t>(l)), means.cols());
        if (t + 1 < least)
            continue;
        const std::size_t from = t + 1 - least; // latest begin of a stay that ends after t
        const std::vector<double>& before = sums[from % least];
        for (std::size_t l = 0; l < labels; ++l) {
            const double start = (ends[from].label == l ? ends[from].second : ends[from].best) +
                                 price_of_change - before[l];
            if (start < entered[l]) {
                entered[l] = start;
                entry[l] = static_cast<std::uint32_t>(from);
            }
            begins[t * labels + l] = entry[l];
            const double total = entered[l] + running[l];
            End& end = ends[t + 1];
            if (total < end.best) {
                end.second = end.best;
                end.best = total;
                end.label = l;
            } else {
                end.second = std::min(end.second, total);
            }
        }
    }
    std::vector<Stay> stays;
    std::size_t next = labels; // the label of the stay after
    for (std::size_t t = n; t > 0;) {
        std::size_t label = ends[t].label;
        if (label == next) // the cheapest stay of another label
            for (std::size_t l = 0, found = labels; l < labels; ++l)
                if (l != next && (found == labels ||
                                  begins[(t - 1) * labels + l] < begins[(t - 1) * labels + found]))
                    label = found = l;
        const std::size_t begin = begins[(t - 1) * labels + label];
        stays.push_back({{static_cast<std::int64_t>(begin), static_cast<std::int64_t>(t)}, label});
        next = label;
        t = begin;
    }
    std::reverse(stays.begin(), stays.end());
    return stays;
}

/// Moves each border towards its louder side, by the ratio of the speeds beside it.
void shift(const Signal& signal, std::vector<Stay>& stays) {
    const auto speed = [&](double from, double to) {
        double squares = 0, count = 0;
        for (auto i = static_cast<std::int64_t>(std::max(from, 0.0));
             i < static_cast<std::int64_t>(to) && i < signal.rows(); ++i, ++count)
            squares += signal.speed[static_cast<std::size_t>(i)] *
                       signal.speed[static_cast<std::size_t>(i)];
        return count > 0 ? std::sqrt(squares / count) : 0;
    };
    const double near = near_s * signal.rate, far = far_s * signal.rate;
    for (std::size_t i = 1; i < stays.size(); ++i) {
        Rows &a = stays[i - 1].range, &b = stays[i].range;
        const auto at = static_cast<double>(b.begin);
        const double before = speed(std::max(static_cast<double>(a.begin), at - far), at - near);
        const double after = speed(at + near, std::min(static_cast<double>(b.end), at + far));
        if (!(before > 0) || !(after > 0))
            continue;
        const double moved = at - most_shift_s * signal.rate * std::tanh(std::log(before / after));
        a.end = b.begin = std::clamp<std::int64_t>(std::llround(moved), a.begin + 1, b.end - 1);
    }
}

/// Poses and velocities at a lower rate, in units of their mean deviation.
struct Poses {
    Matrix rows;
    std::int64_t step = 1; ///< rows of the signal
    double rate = 0;
    double variance = 0; ///< total
};

Poses make_poses(const Signal& signal, const std::function<void()>& poll) {
    Poses poses;
    poses.step = std::max<std::int64_t>(1, std::lround(signal.rate / poses_per_second));
    poses.rate = signal.rate / static_cast<double>(poses.step);
    const Matrix smooth = gaussian_smoothed(signal.poses.view(), pose_smoothing_s * signal.rate,
                                            Beyond::nothing, poses.step, poll);
    const std::int64_t n = smooth.rows(), p = smooth.cols();
    poses.rows = Matrix(n, 2 * p);
    for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t before = std::max<std::int64_t>(0, i - 1),
                           after = std::min(i + 1, n - 1);
        for (std::int64_t c = 0; c < p; ++c) {
            poses.rows(i, c) = smooth(i, c);
            poses.rows(i, p + c) = after > before ? velocity_weight * 0.1 * poses.rate *
                                                        (smooth(after, c) - smooth(before, c)) /
                                                        static_cast<double>(after - before)
                                                  : 0;
        }
    }
    poses.variance = total_variance(poses.rows.view());
    return poses;
}

/// Examples of each label, away from its borders, evenly over time.
std::vector<std::vector<std::int64_t>> examples_of(const std::vector<Stay>& stays,
                                                   const Poses& poses, std::size_t labels) {
    std::vector<std::vector<std::int64_t>> examples(labels);
    for (const Stay& stay : stays) {
        const std::int64_t begin = stay.range.begin / poses.step;
        const std::int64_t end = std::min(stay.range.end / poses.step, poses.rows.rows());
        const auto away =
            std::min(static_cast<std::int64_t>(away_s * poses.rate), (end - begin) / 3);
        for (std::int64_t i = begin + away; i < end - away; ++i)
            examples[stay.label].push_back(i);
    }
    for (auto& list : examples) {
        if (list.size() <= most_examples)
            continue;
        std::vector<std::int64_t> some;
        for (std::size_t i = 0; i < most_examples; ++i)
            some.push_back(list[i * (list.size() - 1) / (most_examples - 1)]);
        list.swap(some);
    }
    return examples;
}

/// How far a pose is from the nearest example, 0 to 1.
double distance(const Poses& poses, std::int64_t at, const std::vector<std::int64_t>& examples) {
    const auto skipped = static_cast<std::int64_t>(skipped_s * poses.rate);
    double least = unlike * poses.variance;
    for (const std::int64_t example : examples)
        if (std::abs(example - at) >= skipped)
            least = std::min(least, squared_distance(poses.rows.row(at), poses.rows.row(example),
                                                     poses.rows.cols()));
    return least / (unlike * poses.variance);
}

/// The middle of the places at which poses before are best like the left behavior's, and those
/// after like the right one's.
std::int64_t best_place(const Poses& poses, const Stay& left, const Stay& right,
                        const std::vector<std::vector<std::int64_t>>& examples) {
    const auto middle = [](const Rows& range) { return (range.begin + range.end) / 2; };
    const auto reach = static_cast<std::int64_t>(window_s * poses.rate);
    const std::int64_t at = right.range.begin / poses.step;
    const std::int64_t first = std::max(at - reach, middle(left.range) / poses.step);
    const std::int64_t last =
        std::min({at + reach, middle(right.range) / poses.step, poses.rows.rows()});
    std::vector<double> gains{0};
    for (std::int64_t i = first; i < last; ++i)
        gains.push_back(gains.back() + distance(poses, i, examples[left.label]) -
                        distance(poses, i, examples[right.label]));
    const double best = *std::min_element(gains.begin(), gains.end());
    double sum = 0, count = 0;
    for (std::size_t j = 0; j < gains.size(); ++j)
        if (gains[j] <= best + about_as_good) {
            sum += static_cast<double>(j);
            ++count;
        }
    return (first + std::llround(sum / count)) * poses.step;
}

void place(const Signal& signal, std::size_t labels, std::vector<Stay>& stays,
           const std::function<void()>& poll) {
    const Poses poses = make_poses(signal, poll);
    if (!(poses.variance > 0))
        return;
    const auto examples = examples_of(stays, poses, labels);
    const std::vector<Stay> before = stays;
    for (std::size_t i = 1; i < stays.size(); ++i) {
        if (before[i - 1].label == before[i].label)
            continue;
        if (poll)
            poll();
        const std::int64_t at = best_place(poses, before[i - 1], before[i], examples);
        stays[i - 1].range.end = stays[i].range.begin =
            std::clamp(at, stays[i - 1].range.begin + 1, before[i].range.end - 1);
    }
}

} // namespace

std::vector<std::int64_t> behavior_borders(const Signal& signal, const KernelFeatures& features,
                                           double price, const std::function<void()>& poll) {
    const std::vector<std::int64_t> moments = change_points(features, price, poll);
    if (moments.empty())
        return {};
    std::vector<Stay> stays = labeled(features, moments, poll);
    std::size_t labels = 0;
    for (const Stay& stay : stays)
        labels = std::max(labels, stay.label + 1);
    for (int round = 0;
         round < rounds && labels > 1 && labels <= most_behaviors && price >= border_price; ++round)
        stays = assigned(features, means_of(features, stays, labels), poll);
    for (Stay& stay : stays) {
        stay.range.begin *= features.step();
        stay.range.end = std::min(stay.range.end * features.step(), signal.rows());
    }
    shift(signal, stays);
    place(signal, labels, stays, poll);
    std::vector<std::int64_t> borders;
    for (std::size_t i = 1; i < stays.size(); ++i)
        borders.push_back(stays[i].range.begin);
    return borders;
}

} // namespace stltsa::motion
