// SPDX-License-Identifier: BSD-3-Clause
#include "motion/period/period_track.hpp"

#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "linalg/gaussian.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/period/lag_map.hpp"

namespace stltsa::motion {
namespace {

// Scores are per second.
/// The match of repeated motion; below it, none is the better state.
constexpr double none_score = 0.35;
/// A lag must match better than some shorter lag by this: slow motion matches at any short lag.
/// What it lacks counts so many times: once, and smooth noise has cycles.
constexpr double least_rise = 0.5;
constexpr double price_of_rise = 2;
/// Price for each doubling of the lag, since multiples of a period match as well.
constexpr double price_of_doubling = 0.05;
/// Prices of a change of the lag by a factor of e, of a jump to any lag, and of beginning or
/// ending.
constexpr double price_of_change = 0.6;
constexpr double price_of_jump = 0.4;
constexpr double price_of_border = 0.2;
/// Most lags of the grid that the track moves at a time without a jump: 12 % in an eighth of a
/// second.
constexpr int most_move = 4;
/// A shorter lag is the period if it matches nearly as well, after a clear minimum, at half of the
/// moments: a turn within a period is like itself only now and then, and a way there and back, of
/// which strides are the period, interrupts them at its ends.
constexpr double about_as_good = 0.15;
constexpr double clear_minimum = 0.25;
constexpr double shortest_fraction = 0.12;
constexpr double longest_fraction = 0.8;
/// Turns that match better than this are all alike. A multiple of them is the period if it matches
/// nearly as well as they do, and the multiples below it clearly less.
constexpr double near_match = 0.8;
constexpr double nearly_as_good = 0.1;
constexpr double clear_rise = 0.12;
constexpr double off_multiple = 0.4;
/// Lags that differ more from one moment to the next, on a log scale, are of two stretches.
constexpr double same_stretch = 0.15;
/// Shorter lags than the shortest period are needed to see the match fall before it rises.
constexpr double lags_below = 0.5;
constexpr double least_lag_rows = 3;
/// Longest lag as a share of the range: a period and a little more.
constexpr double longest_share = 1 / 1.3;
constexpr double shortest_range_s = 1.2;
/// Sigma of the smoothing of the track in periods.
constexpr double track_smoothing = 0.5;

/// The most probable sequence of lags, or no lag, over time (Viterbi).
class Tracker {
  public:
    Tracker(const LagMap& map, std::size_t first, double dt)
        : map_(map), first_(first), states_(map.lags.size() - first), dt_(dt),
          from_(static_cast<std::size_t>(map.times) * (states_ + 1)) {
        for (std::size_t s = 0; s < states_; ++s)
            logs_.push_back(std::log(map.lags[first + s]));
    }

    /// For each time the index of the lag from `first` on, or states() for none.
    std::vector<std::size_t> path();
    std::size_t states() const { return states_; }

  private:
    void score(std::int64_t time, std::vector<double>& scores) const;
    void step(std::int64_t time);

    const LagMap& map_;
    std::size_t first_;
    std::size_t states_;
    double dt_;
    std::vector<double> logs_;
    std::vector<std::uint16_t> from_; ///< times x (states + none): the state before
    std::vector<double> total_, next_, scores_;
};

void Tracker::score(std::int64_t time, std::vector<double>& scores) const {
    scores.resize(states_);
    float lowest = 9;
    for (std::size_t l = 0; l < map_.lags.size(); ++l) {
        const float match = map_.at(time, l);
        lowest = std::min(lowest, match);
        if (l < first_)
            continue;
        const double rise = static_cast<double>(match) - static_cast<double>(lowest);
        scores[l - first_] =
            dt_ * (static_cast<double>(match) - price_of_rise * std::max(0.0, least_rise - rise) -
                   price_of_doubling * std::log2(map_.lags[l] / map_.lags[first_]));
    }
}

void Tracker::step(std::int64_t time) {
    score(time, scores_);
    const auto best = static_cast<std::size_t>(
        std::max_element(total_.begin(), total_.begin() + static_cast<std::ptrdiff_t>(states_)) -
        total_.begin());
    const double from_none = total_[states_] - price_of_border;
    const double from_jump = total_[best] - price_of_jump;
    std::uint16_t* from = &from_[static_cast<std::size_t>(time) * (states_ + 1)];
    for (std::size_t s = 0; s < states_; ++s) {
        double value = total_[s];
        std::size_t source = s;
        const std::size_t low = s < most_move ? 0 : s - most_move;
        for (std::size_t o = low; o <= std::min(states_ - 1, s + most_move); ++o) {
            const double moved = total_[o] - price_of_change * std::abs(logs_[s] - logs_[o]);
            if (moved > value) {
                value = moved;
                source = o;
            }
        }
        if (std::max(from_none, from_jump) > value) {
            value = std::max(from_none, from_jump);
            source = from_none >= from_jump ? states_ : best;
        }
        next_[s] = value + scores_[s];
        from[s] = static_cast<std::uint16_t>(source);
    }
    const double ended = total_[best] - price_of_border;
    from[states_] = static_cast<std::uint16_t>(total_[states_] >= ended ? states_ : best);
    next_[states_] = std::max(total_[states_], ended) + none_score * dt_;
    total_.swap(next_);
}

std::vector<std::size_t> Tracker::path() {
    score(0, total_);
    total_.push_back(none_score * dt_);
    next_.resize(total_.size());
    for (std::int64_t t = 1; t < map_.times; ++t) {
        step(t);
        checkpoint(static_cast<std::int64_t>(states_) * (2 * most_move + 1));
    }
    std::vector<std::size_t> path(static_cast<std::size_t>(map_.times));
    path.back() =
        static_cast<std::size_t>(std::max_element(total_.begin(), total_.end()) - total_.begin());
    for (std::size_t t = path.size() - 1; t > 0; --t)
        path[t - 1] = from_[t * (states_ + 1) + path[t]];
    return path;
}

/// The match at a lag between those of the grid.
double match_at(const LagMap& map, std::int64_t time, double lag) {
    if (lag <= map.lags.front())
        return map.at(time, 0);
    if (lag >= map.lags.back())
        return map.at(time, map.lags.size() - 1);
    const auto above = static_cast<std::size_t>(
        std::upper_bound(map.lags.begin(), map.lags.end(), lag) - map.lags.begin());
    const double part =
        std::log(lag / map.lags[above - 1]) / std::log(map.lags[above] / map.lags[above - 1]);
    return (1 - part) * static_cast<double>(map.at(time, above - 1)) +
           part * static_cast<double>(map.at(time, above));
}

/// The median match of the tracked lags, each multiplied by the factor.
double usual_match(const LagMap& map, std::int64_t first, const std::vector<double>& lags,
                   double factor) {
    std::vector<double> matches;
    for (std::size_t i = 0; i < lags.size(); ++i)
        matches.push_back(match_at(map, first + static_cast<std::int64_t>(i), factor * lags[i]));
    return median(matches);
}

/// Shares of the tracked lags: that which is the period, less than 1 if a shorter lag matches about
/// as well most of the time; and otherwise the shortest that matches at all, 0 if none does.
struct Octave {
    double period = 1;
    double shortest = 0;
};

Octave octave(const LagMap& map, double shortest, std::int64_t first,
              const std::vector<double>& lags) {
    constexpr double step = 0.03;
    const double needed = usual_match(map, first, lags, 1) - about_as_good;
    const double below = map.lags.front() / median(lags);
    Octave found;
    double before = -1, here = -1, lowest = 1, fraction = 0;
    for (double x = std::log(std::max(shortest_fraction, below));
         x <= std::log(longest_fraction) + 2 * step; x += step) {
        const double after = usual_match(map, first, lags, std::exp(x));
        if (fraction > 0 && fraction <= longest_fraction && here >= before && here >= after &&
            here - lowest >= clear_minimum && fraction * median(lags) >= shortest) {
            if (here >= needed) {
                found.period = fraction;
                return found;
            }
            if (here >= none_score && found.shortest == 0)
                found.shortest = fraction;
        }
        before = here;
        here = after;
        fraction = std::exp(x);
        lowest = std::min(lowest, here);
    }
    return found;
}

/// The multiple of the tracked lags that is the period: 1, or more if turns resemble only their
/// neighbors, as in a spiral: the match falls over the next multiples, and rises by clear_rise at
/// the period of the whole.
double multiple(const LagMap& map, std::int64_t first, const std::vector<double>& lags) {
    const double once = usual_match(map, first, lags, 1);
    const double rows = static_cast<double>(std::ssize(lags) * map.hop);
    const double most = std::min(map.lags.back(), rows / min_turns) / median(lags);
    double lowest = once, best = once - nearly_as_good, result = 1;
    for (double turns = 2; once < near_match && turns <= most; ++turns) {
        double match = -1, at = turns;
        for (double off = -off_multiple; off <= off_multiple; off += off_multiple / 4)
            if (const double found = usual_match(map, first, lags, turns + off); found > match) {
                match = found;
                at = turns + off;
            }
        if (match >= best && match >= lowest + clear_rise) {
            best = match + clear_rise / 2;
            result = at;
        }
        lowest = std::min(lowest, match);
    }
    return result;
}

/// The lags at the map's times, linear between them and smoothed.
std::vector<double> per_row(const std::vector<double>& lags, std::int64_t hop, std::int64_t rows) {
    Matrix period(rows, 1);
    for (std::int64_t i = 0; i < rows; ++i) {
        const double place = static_cast<double>(i) / static_cast<double>(hop);
        row_at({lags.data(), static_cast<std::int64_t>(lags.size()), 1, 1}, place, period.row(i));
    }
    const Matrix smoothed =
        gaussian_smoothed(period.view(), track_smoothing * median(lags), Beyond::reflection);
    std::vector<double> result(smoothed.data(), smoothed.data() + rows);
    const auto [least, most] = std::minmax_element(lags.begin(), lags.end());
    for (double& value : result) // a reflected ramp may overshoot
        value = std::clamp(value, *least, *most);
    return result;
}

Stretch make_stretch(const LagMap& map, std::size_t first_state, std::int64_t begin,
                     std::int64_t end, const std::vector<std::size_t>& path, Rows range) {
    std::vector<double> lags;
    for (std::int64_t t = begin; t < end; ++t) {
        const std::size_t lag = first_state + path[static_cast<std::size_t>(t)];
        lags.push_back(map.lags[lag]);
    }
    Stretch stretch;
    const Octave octaves = octave(map, map.lags[first_state], begin, lags);
    const double tracked = median(lags);
    for (double& lag : lags)
        lag *= octaves.period;
    const double turns = multiple(map, begin, lags);
    for (double& lag : lags)
        lag *= turns;
    stretch.other_period = turns > 1            ? tracked * octaves.period
                           : octaves.period < 1 ? tracked
                                                : tracked * octaves.shortest;
    stretch.quality = usual_match(map, begin, lags, 1);
    stretch.rows = {range.begin + begin * map.hop,
                    end == map.times ? range.end : range.begin + end * map.hop};
    stretch.period = per_row(lags, map.hop, stretch.rows.count());
    return stretch;
}

/// For messages: the lag that matches best over the whole range, after its match has risen.
void set_best(const LagMap& map, std::size_t first, double rate, PeriodTrack& track) {
    double lowest = 9;
    for (std::size_t l = 0; l < map.lags.size(); ++l) {
        double mean = 0;
        for (std::int64_t t = 0; t < map.times; ++t)
            mean += static_cast<double>(map.at(t, l)) / static_cast<double>(map.times);
        lowest = std::min(lowest, mean);
        if (l >= first && mean - lowest >= clear_minimum && mean > track.best_match) {
            track.best_match = mean;
            track.best_lag_s = map.lags[l] / rate;
        }
    }
}

} // namespace

double Stretch::period_at(double row) const {
    const auto last = static_cast<double>(period.size() - 1);
    return period[static_cast<std::size_t>(
        std::clamp(row - static_cast<double>(rows.begin), 0.0, last))];
}

PeriodTrack track_period(const Signal& signal, Rows range, const PeriodRange& periods) {
    PeriodTrack track;
    const double rate = signal.rate;
    const double longest =
        std::min(periods.longest_s * rate, longest_share * static_cast<double>(range.count()));
    const double shortest = periods.shortest_s * rate;
    if (static_cast<double>(range.count()) < shortest_range_s * rate || longest <= 1.2 * shortest)
        return track;
    const LagMap map =
        make_lag_map(signal, range, std::max(lags_below * shortest, least_lag_rows), longest);
    const auto first = static_cast<std::size_t>(
        std::lower_bound(map.lags.begin(), map.lags.end(), shortest) - map.lags.begin());
    if (first >= map.lags.size())
        return track;
    set_best(map, first, rate, track);
    Tracker tracker(map, first, static_cast<double>(map.hop) / rate);
    const auto path = tracker.path();
    for (std::int64_t t = 0; t < map.times;) {
        std::int64_t end = t;
        const auto lag = [&](std::int64_t time) { return path[static_cast<std::size_t>(time)]; };
        while (end < map.times && lag(end) < tracker.states() &&
               (end == t || std::abs(std::log(map.lags[first + lag(end)] /
                                              map.lags[first + lag(end - 1)])) <= same_stretch))
            ++end;
        if (end > t)
            track.stretches.push_back(make_stretch(map, first, t, end, path, range));
        t = std::max(end, t + 1);
    }
    return track;
}

} // namespace stltsa::motion
