// SPDX-License-Identifier: BSD-3-Clause
#include "phase/live.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/numbers.hpp"
#include "linalg/simd.hpp"

namespace stltsa::phase {
namespace {

constexpr std::int64_t rate_count = 17;
constexpr double least_rate = 0.4, most_rate = 2; ///< of the usual one
/// Frames a second for which the next constants were found.
constexpr double usual_rate = 30;
/// Per frame: spread of the phase, in places, and of the rate, in usual rates.
constexpr double phase_spread = 0.4;
constexpr double rate_spread = 0.06;
/// Rate per second at which a body in motion stops, and at which one at rest moves on. Without rest
/// among the states, the phase of a stopped body moves on by 5.1 % of a cycle (median; 22.8 % at
/// most), with it by 1.7 % (10.7 % at most; measure/live).
constexpr double stops = 0.3, resumes = 3;
constexpr double least_share = 1e-9; ///< of a rate that becomes another one
constexpr double prior_spread = 0.35;
/// Share of anything being possible; more in unknown motion.
constexpr double surprise = 0.002, surprise_far = 0.02;
constexpr double far = 1.5;
/// Distance from the mean cycle, as a share of the deviation, beyond which a motion is another one:
/// of 42 clips of the same style none is flagged, waves, runs and kicks always.
constexpr double other_motion = 0.65;
/// Seconds beyond that, or within, until `known` changes.
constexpr double flag_s = 0.1;
/// What the delay of the filter at another rate adds to the phase: seconds times the difference of
/// the rates. Poses are two time constants late, their velocity three.
constexpr double delay_s = 2.5 * filter_s;
constexpr double longest_gap_s = 1;
/// Time that falls by less is a late packet or a coarse clock.
constexpr double most_late_s = 0.25;
/// Steps up to this are none: velocities divide by them.
constexpr double same_time_s = 1e-6;
/// Poses farther away, in deviations of the cycle, are no poses: in 168 pairs of a walk and another
/// clip none is farther than 4. The effect of a frame 900 away is gone within 0.3 s.
constexpr double most_away = 1000;
/// A phase that falls by more is a jump of the stream, not noise; in turns.
constexpr double jump_back = 0.25;
/// Speed, as a share of the usual one, below which the body is still.
constexpr double still_speed = 0.1;

} // namespace

LivePhase::LivePhase(const LiveCycle& cycle, std::span<const double> marks)
    : cycle_(cycle), filter_(cycle.weights.size()), both_(2 * cycle.weights.size()),
      coordinates_(static_cast<std::size_t>(cycle.directions.rows())), whitened_(coordinates_),
      whitened_places_(place_count, cycle.directions.rows()), whitened_rests_(whitened_places_),
      squared_(place_count), squared_rest_(place_count), likely_(rate_count + 1, place_count),
      moved_(place_count), blurred_(rate_count, place_count), blur_(rate_count),
      circle_(2, place_count), marks_(marks.begin(), marks.end()) {
    for (std::int64_t g = 0; g < place_count; ++g) {
        whiten(cycle.whitening, cycle.places.row(g), whitened_places_.row(g));
        whiten(cycle.whitening, cycle.rests.row(g), whitened_rests_.row(g));
        const double angle = turn * static_cast<double>(g) / place_count;
        circle_(0, g) = std::cos(angle);
        circle_(1, g) = std::sin(angle);
    }
    double sum = 0;
    for (std::int64_t r = 0; r < rate_count; ++r) {
        const double share = least_rate + (most_rate - least_rate) * static_cast<double>(r) /
                                              static_cast<double>(rate_count - 1);
        rates_.push_back(share * cycle.turns_per_second);
        const double off = (share - 1) / prior_spread;
        prior_.push_back(std::exp(-off * off / 2));
        sum += prior_.back();
    }
    for (double& value : prior_)
        value /= sum;
    start();
}

/// Without a word about what was before.
void LivePhase::start() {
    for (std::int64_t r = 0; r < rate_count; ++r)
        std::fill_n(likely_.row(r), place_count,
                    prior_[static_cast<std::size_t>(r)] / static_cast<double>(place_count));
    std::fill_n(likely_.row(rate_count), place_count, 0.0);
    begun_ = false;
    still_ = false;
}

bool LivePhase::possible(const double* features) const {
    const double away = sum_of(cycle_.features(), [&](std::int64_t c) {
        const auto at = static_cast<std::size_t>(c);
        const double off = features[c] * cycle_.weights[at] - cycle_.mean[at];
        return off * off;
    });
    return away <= most_away * most_away * cycle_.variance; // false for NaN
}

void LivePhase::filter(double seconds, const double* features) {
    const std::int64_t p = cycle_.features();
    for (std::int64_t c = 0; c < p; ++c) // both_ holds the used features for a moment
        both_[static_cast<std::size_t>(c)] =
            features[c] * cycle_.weights[static_cast<std::size_t>(c)];
    if (begun_)
        filter_.step(seconds, both_.data());
    else
        filter_.start(both_.data());
    const double scale = velocity_scale(cycle_.period);
    const auto count = static_cast<std::size_t>(p);
    for (std::int64_t c = 0; c < p; ++c) {
        const auto at = static_cast<std::size_t>(c);
        both_[at] = filter_.pose()[at] - cycle_.mean[at];
        both_[at + count] = scale * filter_.velocity()[at] - cycle_.mean[at + count];
    }
}

void LivePhase::project() {
    const std::int64_t n = cycle_.directions.cols();
    double within = 0;
    for (std::size_t d = 0; d < coordinates_.size(); ++d) {
        coordinates_[d] = dot(cycle_.directions.row(static_cast<std::int64_t>(d)), both_.data(), n);
        within += coordinates_[d] * coordinates_[d];
    }
    outside_ = std::max(0.0, dot(both_.data(), both_.data(), n) - within);
    whiten(cycle_.whitening, coordinates_.data(), whitened_.data());
}

/// Sets the whitened distances, and gives the distance from the nearest place.
double LivePhase::nearest_place() {
    const auto count = static_cast<std::int64_t>(whitened_.size());
    for (std::int64_t g = 0; g < place_count; ++g) {
        squared_[static_cast<std::size_t>(g)] =
            squared_distance(whitened_places_.row(g), whitened_.data(), count);
        squared_rest_[static_cast<std::size_t>(g)] =
            squared_distance(whitened_rests_.row(g), whitened_.data(), count);
    }
    const auto best = std::ranges::min_element(squared_) - squared_.begin();
    const double off = squared_distance(cycle_.places.row(best), coordinates_.data(), count);
    return std::sqrt((off + outside_) / cycle_.variance) / other_motion;
}

/// Every rate moves its phases on; then both blur, and a little of anything is possible.
void LivePhase::predict(double seconds, bool is_far) {
    const double frames = seconds * usual_rate;
    const double side = std::min(phase_spread * phase_spread * frames / 2, 1.0 / 3);
    for (std::int64_t r = 0; r < rate_count; ++r) {
        double moved = rates_[static_cast<std::size_t>(r)] * seconds;
        moved = (moved - std::floor(moved)) * place_count;
        const auto whole = static_cast<std::int64_t>(moved);
        const double part = moved - static_cast<double>(whole);
        for (std::int64_t g = 0; g < place_count; ++g) {
            const std::int64_t from = (g - whole + 2 * place_count) % place_count;
            const std::int64_t next = (from + place_count - 1) % place_count;
            moved_[static_cast<std::size_t>(g)] =
                (1 - part) * likely_(r, from) + part * likely_(r, next);
        }
        for (std::int64_t g = 0; g < place_count; ++g)
            blurred_(r, g) =
                (1 - 2 * side) * moved_[static_cast<std::size_t>(g)] +
                side * (moved_[static_cast<std::size_t>((g + 1) % place_count)] +
                        moved_[static_cast<std::size_t>((g + place_count - 1) % place_count)]);
    }
    const double rate_step =
        (most_rate - least_rate) / static_cast<double>(rate_count - 1) / rate_spread;
    for (std::int64_t d = 0; d < rate_count; ++d) {
        const double off = static_cast<double>(d) * rate_step;
        blur_[static_cast<std::size_t>(d)] = std::exp(-off * off / 2 / std::max(frames, 1e-9));
    }
    std::fill_n(likely_.data(), rate_count * place_count, 0.0);
    for (std::int64_t from = 0; from < rate_count; ++from) {
        double total = 0;
        for (std::int64_t to = 0; to < rate_count; ++to)
            total += blur_[static_cast<std::size_t>(std::abs(from - to))];
        for (std::int64_t to = 0; to < rate_count; ++to)
            if (const double share = blur_[static_cast<std::size_t>(std::abs(from - to))] / total;
                share > least_share)
                axpy(share, blurred_.row(from), likely_.row(to), place_count);
    }
    rest(seconds);
    double total = 0;
    for (std::int64_t r = 0; r <= rate_count; ++r)
        total += sum(likely_.row(r), place_count);
    const double share = is_far ? surprise_far : surprise;
    for (double& value : std::span(likely_.row(rate_count), place_count))
        value *= (1 - share) / total;
    for (std::int64_t r = 0; r < rate_count; ++r)
        for (std::int64_t g = 0; g < place_count; ++g)
            likely_(r, g) = (1 - share) * likely_(r, g) / total +
                            share * prior_[static_cast<std::size_t>(r)] / place_count;
}

/// Some of what moves comes to rest where it is, and some of what rests moves on.
void LivePhase::rest(double seconds) {
    const double stop = -std::expm1(-stops * seconds), resume = -std::expm1(-resumes * seconds);
    for (std::int64_t g = 0; g < place_count; ++g) {
        const double rested = likely_(rate_count, g);
        double stopped = 0;
        for (std::int64_t r = 0; r < rate_count; ++r) {
            stopped += stop * likely_(r, g);
            likely_(r, g) =
                (1 - stop) * likely_(r, g) + resume * rested * prior_[static_cast<std::size_t>(r)];
        }
        likely_(rate_count, g) = (1 - resume) * rested + stopped;
    }
}

/// The whole likelihood, softened only where the frame is far from the cycle.
void LivePhase::correct() {
    const double least =
        std::min(*std::ranges::min_element(squared_), *std::ranges::min_element(squared_rest_));
    const double soft = std::max(1.0, least / (4 * cycle_.typical));
    double total = 0;
    for (std::int64_t g = 0; g < place_count; ++g) {
        const auto at = static_cast<std::size_t>(g);
        const double weight = std::exp(-(squared_[at] - least) / 2 / soft);
        for (std::int64_t r = 0; r < rate_count; ++r)
            total += likely_(r, g) *= weight;
        total += likely_(rate_count, g) *= std::exp(-(squared_rest_[at] - least) / 2 / soft);
    }
    for (std::int64_t i = 0; i < (rate_count + 1) * place_count; ++i)
        likely_.data()[i] /= total;
}

/// All has come to rest where it is. Which place that is shows while the filter comes to rest.
void LivePhase::settle() {
    if (rested_s_ > warm_up_s)
        return;
    const double least = *std::ranges::min_element(squared_rest_);
    const double soft = std::max(1.0, least / (4 * cycle_.typical));
    double total = 0;
    for (std::int64_t g = 0; g < place_count; ++g) {
        double at_place = likely_(rate_count, g);
        for (std::int64_t r = 0; r < rate_count; ++r)
            at_place += std::exchange(likely_(r, g), 0);
        const double off = squared_rest_[static_cast<std::size_t>(g)] - least;
        total += likely_(rate_count, g) = at_place * std::exp(-off / 2 / soft);
    }
    for (double& value : std::span(likely_.row(rate_count), place_count))
        value /= total;
}

/// A body that stands still keeps its phase: without velocity, other places of the cycle look
/// alike.
void LivePhase::notice_rest(double seconds) {
    const std::int64_t p = cycle_.features();
    const double speed = velocity_scale(cycle_.period) *
                         std::sqrt(dot(filter_.velocity().data(), filter_.velocity().data(), p));
    age_s_ = begun_ ? age_s_ + seconds : 0;
    still_ = age_s_ > warm_up_s && speed < still_speed * cycle_.usual_speed;
    rested_s_ = still_ ? rested_s_ + seconds : 0;
}

/// Phase, rate and how sure they are; counts turns.
LiveFrame LivePhase::estimate() {
    double cosine = 0, sine = 0, rate = 0, resting = 0;
    for (std::int64_t g = 0; g < place_count; ++g) {
        double at_place = likely_(rate_count, g);
        resting += at_place;
        for (std::int64_t r = 0; r < rate_count; ++r) {
            at_place += likely_(r, g);
            rate += likely_(r, g) * rates_[static_cast<std::size_t>(r)];
        }
        cosine += at_place * circle_(0, g);
        sine += at_place * circle_(1, g);
    }
    double phase = std::atan2(sine, cosine) / turn +
                   delay_s * (rate - (1 - resting) * cycle_.turns_per_second);
    phase -= std::floor(phase);
    const double moved = begun_ ? std::remainder(phase - last_phase_, 1.0) : 0;
    turns_ += moved;
    unwrapped_ = begun_ ? unwrapped_ + moved : phase;
    if (!begun_)
        reached_ = unwrapped_;
    last_phase_ = phase;
    LiveFrame frame;
    frame.phase = phase < 1 ? phase : 0;
    frame.turns_per_second = still_ ? 0 : rate;
    frame.turns = turns_;
    frame.confidence = std::hypot(cosine, sine);
    frame.still = still_;
    return frame;
}

LiveFrame LivePhase::answer(double seconds, double distance) {
    LiveFrame frame = estimate();
    unknown_s_ = std::clamp(unknown_s_ + (distance > 1 ? seconds : -seconds), 0.0, 2 * flag_s);
    known_ = known_ ? unknown_s_ < flag_s : unknown_s_ <= flag_s / 2;
    frame.distance = distance;
    frame.known = known_;
    frame.passed = passed();
    return frame;
}

/// Marks between the furthest phase so far and this one. After a jump back they count anew. None
/// counts before the filter has settled, because its first phases jump.
std::int64_t LivePhase::passed() {
    if (unwrapped_ < reached_ - jump_back || age_s_ <= warm_up_s)
        reached_ = unwrapped_;
    std::int64_t bits = 0;
    if (unwrapped_ <= reached_)
        return 0;
    for (std::size_t i = 0; i < marks_.size(); ++i)
        if (known_ && std::floor(unwrapped_ - marks_[i]) > std::floor(reached_ - marks_[i]))
            bits |= std::int64_t{1} << i;
    reached_ = unwrapped_;
    return bits;
}

LiveFrame LivePhase::push(double seconds, const double* features) {
    if (!possible(features))
        return go_on(seconds);
    double passed = seconds - last_;
    if (begun_ && passed <= same_time_s && passed >= -most_late_s) {
        latest_.passed = 0;
        return latest_;
    }
    if (!begun_ || passed < 0 || passed > longest_gap_s) {
        start();
        passed = 1 / cycle_.rate;
        now_ = seconds - passed;
    }
    filter(passed, features);
    project();
    const double distance = nearest_place();
    notice_rest(passed);
    if (still_) {
        settle();
    } else {
        predict(std::max(seconds - now_, 0.0), distance > far);
        correct();
    }
    latest_ = answer(passed, distance);
    begun_ = true;
    last_ = seconds;
    now_ = std::max(now_, seconds);
    return latest_;
}

LiveFrame LivePhase::go_on(double seconds) {
    const double passed = seconds - now_;
    if (begun_ && passed > 0 && seconds - last_ <= longest_gap_s) {
        if (!still_)
            predict(passed, false);
        latest_ = estimate();
        now_ = seconds;
    }
    latest_.known = false;
    latest_.passed = 0;
    latest_.distance = std::numeric_limits<double>::quiet_NaN();
    if (!begun_ || seconds - last_ > longest_gap_s)
        latest_.confidence = 0;
    return latest_;
}

} // namespace stltsa::phase
