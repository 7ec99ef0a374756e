// SPDX-License-Identifier: BSD-3-Clause
#include "phase/events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/checkpoint.hpp"
#include "base/numbers.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/extrema.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::phase {
namespace {

/// Templates reach so far to each side, as a share of a cycle; longer ones follow the motion before
/// and after the event.
constexpr double half_window = 0.05;
constexpr std::int64_t window_steps = 8; ///< to each side
/// An event lies so near to where the phase comes round.
constexpr double reach = 0.10;
constexpr int rounds = 4;
/// Added to the variance of each column, as a share of the mean one, before weighing by it.
constexpr double variance_floor = 0.1;
/// Cycles farther from the mean, in units of the usual distance, teach no template.
constexpr double most_distance = 3;
/// Marks within cycles are up to this remote, where remoteness says nothing about the error; marks
/// at the start of a walk, whose events are wrong, have 7.
constexpr double usual_remoteness = 2;
/// Median from this number on, mean of fewer.
constexpr std::size_t many = 5;
constexpr double of_phase = 0.25, of_direct = 0.25, of_group = 0.5;
constexpr double least_error_ms = 3;
/// Ratio of errors outside the cycles, or with marks there, to errors within the cycles. The
/// medians are 16 and 8 ms on a treadmill, 46 and 12 ms overground.
constexpr double doubt_beyond = 2;
/// Error between recordings, as a share of a cycle, if the likeness of the mean cycles is 0; it is
/// proportional to the root of 1 minus the likeness. Median errors: 0.4 % of a cycle at likeness
/// 0.99 (next clip of a style), 1.1 % at 0.95 (other side of the body), 1.0 to 1.5 % at 0.9 (other
/// styles and actors), 2.5 % at 0.83 (other people).
constexpr double error_share = 0.05;
/// Weight of the templates in another recording; the phase has the rest, because bodies differ more
/// around the event than over the cycle. At likenesses of 0.9 to 0.94, 99 % of the events are right
/// within 50 ms; with a weight of a half, 96 %. The median errors are the same.
constexpr double of_template = 0.25;
/// Between recordings: range and step of the common shift, as shares of a cycle.
constexpr double common_reach = 0.08;
constexpr double common_step = 0.004;
/// Smoothness of the map between two mean cycles.
constexpr double map_share = 0.08;

using Rows = std::vector<double>;

/// Offsets of a template's samples from the event, in rows.
Rows offsets_of(const Searched& in) {
    const auto places = static_cast<double>(in.fine.places());
    const double half = half_window * in.mean.period;
    const double step = std::max(1.0, std::round(half * places / window_steps)) / places;
    const auto count = static_cast<std::int64_t>(std::llround(half / step));
    Rows offsets;
    for (std::int64_t i = -count; i <= count; ++i)
        offsets.push_back(static_cast<double>(i) * step);
    return offsets;
}

/// Samples around a row: offsets x columns.
Matrix window(const FineRows& fine, double row, const Rows& offsets) {
    Matrix values(static_cast<std::int64_t>(offsets.size()), fine.cols());
    for (std::size_t i = 0; i < offsets.size(); ++i)
        fine.at(row + offsets[i], values.row(static_cast<std::int64_t>(i)));
    return values;
}

struct Template {
    Matrix values;
    Rows weights; ///< of the columns
};

Matrix typical(const std::vector<Matrix>& windows) {
    constexpr std::int64_t work_of_median = 8; // compared with adding
    Matrix values(windows.front().rows(), windows.front().cols());
    Rows of_all(windows.size());
    for (std::int64_t i = 0; i < values.rows() * values.cols(); ++i) {
        double sum = 0;
        for (std::size_t w = 0; w < windows.size(); ++w)
            sum += of_all[w] = windows[w].data()[i];
        values.data()[i] = windows.size() < many ? sum / static_cast<double>(windows.size())
                                                 : motion::median(of_all);
        checkpoint(work_of_median * std::ssize(windows));
    }
    return values;
}

/// Columns count by how little they vary about the template.
Rows weights_of(const std::vector<Matrix>& windows, const Matrix& about) {
    Rows variance(static_cast<std::size_t>(about.cols()));
    for (const Matrix& each : windows)
        for (std::int64_t r = 0; r < about.rows(); ++r) {
            for (std::int64_t c = 0; c < about.cols(); ++c) {
                const double off = each(r, c) - about(r, c);
                variance[static_cast<std::size_t>(c)] += off * off;
            }
            checkpoint(2 * about.cols());
        }
    double mean = 0;
    for (const double v : variance)
        mean += v / static_cast<double>(variance.size());
    Rows weights;
    for (const double v : variance)
        weights.push_back(mean > 0 ? 1 / (v + variance_floor * mean) : 1);
    return weights;
}

double cost_of(ConstMatrixView values, const Template& like) {
    double cost = 0;
    for (std::int64_t r = 0; r < values.rows; ++r)
        cost += sum_of(values.cols, [&](std::int64_t c) {
            const double off = values(r, c) - like.values(r, c);
            return like.weights[static_cast<std::size_t>(c)] * off * off;
        });
    return cost;
}

/// The lowest of costs at even steps, with a parabola through it and its neighbors; in steps.
double lowest(const Rows& costs) {
    const auto at = std::ranges::min_element(costs) - costs.begin();
    const auto i = static_cast<std::size_t>(at);
    if (i == 0 || i + 1 == costs.size())
        return static_cast<double>(i);
    return static_cast<double>(i) + motion::parabola_vertex(costs[i - 1], costs[i], costs[i + 1]);
}

/// Where the recording is most like the template, near a row; NaN too near the ends.
double refined(const Searched& in, double row, const Template& like, const Rows& offsets) {
    const auto places = static_cast<double>(in.fine.places());
    const double last = static_cast<double>(in.fine.rows() - 1);
    const double far = std::round(reach * in.mean.period * places) / places;
    const double center = std::round(row * places) / places;
    const double begin = std::max(center - far, -offsets.front());
    const double end = std::min(center + far, last - offsets.back());
    if ((end - begin) * places < 2)
        return none;
    // Windows overlap: offsets are whole places.
    const auto count = std::llround((end - begin) * places) + 1;
    const std::int64_t step =
        offsets.size() < 2 ? 1 : std::llround((offsets[1] - offsets[0]) * places);
    Matrix strip = Matrix::unset(count + (std::ssize(offsets) - 1) * step, in.fine.cols());
    for (std::int64_t i = 0; i < strip.rows(); ++i)
        in.fine.at(begin + offsets.front() + static_cast<double>(i) / places, strip.row(i));
    Rows costs;
    for (std::int64_t i = 0; i < count; ++i) {
        costs.push_back(
            cost_of({strip.row(i), std::ssize(offsets), strip.cols(), step * strip.cols()}, like));
        checkpoint(std::ssize(offsets) * strip.cols());
    }
    return begin + lowest(costs) / places;
}

/// A place at which the phase comes round.
struct Candidate {
    double row = 0;
    double distance = 0; ///< of the motion there from the mean cycle
    double beyond = 0;   ///< rows outside cycles
    bool teaches = false;
};

/// Where one run is at a phase.
Candidate candidate_at(const Searched& in, std::size_t run, double phase, const Rows& offsets) {
    const double row = in.runs[run].row_at(phase);
    const double distance =
        interpolated(in.distance[run], row - static_cast<double>(in.runs[run].begin));
    const bool whole =
        row + offsets.front() > 0 && row + offsets.back() < static_cast<double>(in.fine.rows() - 1);
    return {row, distance, rows_beyond(in.known[run], row),
            whole && remoteness(in, distance) < most_distance};
}

/// One in every turn of the runs; of a repetition, which is a run of one turn, one.
std::vector<Candidate> candidates_at(const Searched& in, double phase, const Rows& offsets) {
    std::vector<Candidate> found;
    for (std::size_t r = 0; r < in.runs.size(); ++r) {
        const double first = in.runs[r].phase.front(), last = in.runs[r].phase.back();
        double next = in.cyclic ? phase + std::ceil(first - phase) : phase;
        for (; next >= first && next <= last; ++next) {
            const Candidate candidate = candidate_at(in, r, next, offsets);
            if (candidate.distance <= other_motion)
                found.push_back(candidate);
            if (!in.cyclic)
                break;
        }
    }
    std::ranges::sort(found, {}, &Candidate::row);
    return found;
}

double phase_of(const Place& marks) {
    double sum = 0;
    for (const Mark& mark : marks)
        sum += mark.phase;
    return sum / static_cast<double>(marks.size());
}

Rows rows_of(const std::vector<Candidate>& candidates) {
    Rows rows;
    for (const Candidate& candidate : candidates)
        rows.push_back(candidate.row);
    return rows;
}

/// Median of how far the marks are from the nearest of the places; those in a cycle without a place
/// do not count.
double offset_from(const Searched& in, const Rows& places, const Place& marks) {
    Rows offsets;
    for (const Mark& mark : marks) {
        double best = std::numeric_limits<double>::infinity();
        for (const double place : places)
            if (std::abs(mark.row - place) < std::abs(best))
                best = mark.row - place;
        if (std::abs(best) < in.mean.period / 2)
            offsets.push_back(best);
    }
    return offsets.empty() ? 0 : motion::median(offsets);
}

void shift(Rows& places, double by) {
    for (double& place : places)
        place += by;
}

/// Windows at the candidates that teach, or at all if fewer than two do.
std::vector<Matrix> taught(const Searched& in, const std::vector<Candidate>& candidates,
                           const Rows& places, const Rows& offsets) {
    const auto teachers = std::ranges::count_if(candidates, &Candidate::teaches);
    std::vector<Matrix> windows;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (candidates[i].teaches || teachers < 2) {
            windows.push_back(window(in.fine, places[i], offsets));
            checkpoint(4 * std::ssize(offsets) * in.fine.cols());
        }
    return windows;
}

/// The candidates moved such that their windows are alike; their median stays, because nothing
/// else says where the group is.
Rows group_places(const Searched& in, const std::vector<Candidate>& candidates,
                  const Rows& offsets) {
    const Rows start = rows_of(candidates);
    Rows places = start;
    for (int round = 0; round < rounds; ++round) {
        const auto windows = taught(in, candidates, places, offsets);
        Template like{typical(windows), {}};
        like.weights = weights_of(windows, like.values);
        Rows moved;
        for (std::size_t i = 0; i < start.size(); ++i) {
            const double at = refined(in, start[i], like, offsets);
            places[i] = std::isnan(at) ? start[i] : at;
            if (candidates[i].teaches && !std::isnan(at))
                moved.push_back(at - start[i]);
        }
        shift(places, -motion::median(moved));
    }
    return places;
}

/// Where the recording is like the windows at the marks themselves.
Rows direct_places(const Searched& in, const std::vector<Candidate>& candidates, const Place& marks,
                   const Rows& offsets) {
    const auto windows = taught(in, candidates, rows_of(candidates), offsets);
    std::vector<Matrix> marked;
    for (const Mark& mark : marks)
        marked.push_back(window(in.fine, mark.row, offsets));
    Matrix mean(marked.front().rows(), marked.front().cols());
    for (const Matrix& each : marked)
        axpy(1 / static_cast<double>(marked.size()), each.data(), mean.data(),
             mean.rows() * mean.cols());
    const Template like{std::move(mean), weights_of(windows, typical(windows))};
    Rows places;
    for (const Candidate& candidate : candidates) {
        const double at = refined(in, candidate.row, like, offsets);
        places.push_back(std::isnan(at) ? candidate.row : at);
    }
    return places;
}

/// Where the motion is far from the mean cycle, its phase is not sure: neither are events that are
/// found by marks there.
double doubt_of(const Searched& from, const Place& marks) {
    Rows distances;
    for (const Mark& mark : marks)
        distances.push_back(mark.distance);
    return std::max(1.0, remoteness(from, motion::median(distances)) / usual_remoteness);
}

/// Whether templates help to place the event. In first and last steps they do not, because parts of
/// the body move differently there. The phase does, because it follows the other parts: of 16 foot
/// strikes in walks of 86_01 (CMU), all are within 50 ms by the phase, and 6 with templates.
bool templates_count(const Place& marks, const Candidate& candidate) {
    const auto within = std::ranges::count(marks, 0.0, &Mark::beyond);
    return candidate.beyond == 0 && 2 * within >= std::ssize(marks);
}

double milliseconds(const Searched& in, double rows) {
    return 1000 * rows / in.rate;
}

/// The phase of `to` that looks like a phase of `from`.
double mapped_phase(const MeanCycle& from, const MeanCycle& to, const motion::Offset& offset,
                    double phase) {
    constexpr std::int64_t places = 100, turns = 3;
    Loop centered = from.loop;
    std::fill_n(centered.coefficients.row(0), centered.cols(), 0.0);
    Loop other = to.loop;
    std::fill_n(other.coefficients.row(0), other.cols(), 0.0);
    const double scale = std::clamp(std::sqrt(centered.variance() / other.variance()), 0.5, 2.0);
    Matrix cycle = Matrix::unset(places * turns, other.cols());
    Run run{0, {}};
    for (std::int64_t i = 0; i < cycle.rows(); ++i) {
        run.phase.push_back(static_cast<double>(i) / places);
        other.at(run.phase.back() + offset.shift, cycle.row(i));
        for (std::int64_t c = 0; c < cycle.cols(); ++c)
            cycle(i, c) *= scale;
        checkpoint(2 * other.harmonics() * other.cols());
    }
    const MeanCycle mean{std::move(centered), places, from.variance};
    const Run start = run;
    const Run found = register_with(cycle.view(), mean, std::move(run), 0.2, map_share);
    const double wanted = 1 + phase - std::floor(phase);
    return start.phase_at(found.row_at(wanted)) + offset.shift;
}

/// Median windows of the group, moved by a common shift in rows.
Matrix group_window(const Searched& in, const std::vector<Candidate>& candidates, Rows places,
                    double by, const Rows& offsets) {
    shift(places, by);
    return typical(taught(in, candidates, places, offsets));
}

} // namespace

std::vector<Event> find_events(const Searched& in, const Place& marks) {
    const Rows offsets = offsets_of(in);
    const auto candidates = candidates_at(in, phase_of(marks), offsets);
    if (candidates.empty())
        return {};
    Rows by_phase = rows_of(candidates);
    shift(by_phase, offset_from(in, by_phase, marks));
    const Rows direct = direct_places(in, candidates, marks, offsets);
    Rows group = group_places(in, candidates, offsets);
    shift(group, offset_from(in, group, marks));
    const double doubt = doubt_of(in, marks);
    std::vector<Event> events;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const bool within = templates_count(marks, candidates[i]);
        const double row =
            within ? of_phase * by_phase[i] + of_direct * direct[i] + of_group * group[i]
                   : by_phase[i];
        const auto off = [&](double place) { return (place - row) * (place - row); };
        const double apart = std::sqrt(of_phase * off(by_phase[i]) + of_direct * off(direct[i]) +
                                       of_group * off(group[i]));
        events.push_back(
            {row, (least_error_ms + milliseconds(in, apart)) * doubt * (within ? 1 : doubt_beyond) *
                      remoteness(in, candidates[i].distance)});
    }
    return events;
}

double likeness(const Searched& from, const Searched& in) {
    return motion::offset_between(from.mean.loop, in.mean.loop).likeness;
}

std::vector<Event> find_events(const Searched& from, const Place& marks, const Searched& in) {
    const double phase = phase_of(marks);
    motion::Offset offset = motion::offset_between(from.mean.loop, in.mean.loop);
    const Rows offsets = offsets_of(from);
    // The template of the source, with the marks in its middle.
    const auto sources = candidates_at(from, phase, offsets);
    if (sources.empty())
        return {};
    Rows marked = group_places(from, sources, offsets);
    shift(marked, offset_from(from, marked, marks));
    const auto windows = taught(from, sources, marked, offsets);
    Template like{typical(windows), {}};
    like.weights = weights_of(windows, like.values);
    // The same share of a cycle.
    Rows scaled = offsets;
    for (double& each : scaled)
        each *= in.mean.period / from.mean.period;
    double mapped = mapped_phase(from.mean, in.mean, offset, phase);
    if (!in.cyclic) // a repetition has its events in its own turn
        mapped -= std::round(mapped - phase);
    const auto candidates = candidates_at(in, mapped, offsets_of(in));
    if (candidates.empty())
        return {};
    Rows group = group_places(in, candidates, offsets_of(in));
    // One common shift: cycles of another recording differ alike.
    Rows costs;
    const auto steps = static_cast<int>(std::lround(common_reach / common_step));
    for (int s = -steps; s <= steps; ++s)
        costs.push_back(cost_of(
            group_window(in, candidates, group, s * common_step * in.mean.period, scaled).view(),
            like));
    shift(group, (lowest(costs) - steps) * common_step * in.mean.period);
    const double doubt = doubt_of(from, marks);
    const double least =
        least_error_ms + milliseconds(in, error_share * in.mean.period *
                                              std::sqrt(std::max(0.0, 1 - offset.likeness)));
    std::vector<Event> events;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const double by_phase = candidates[i].row;
        const double apart = std::abs(group[i] - by_phase);
        events.push_back(
            {by_phase +
                 (templates_count(marks, candidates[i]) ? of_template * (group[i] - by_phase) : 0),
             (least + milliseconds(in, apart)) * doubt * remoteness(in, candidates[i].distance)});
    }
    return events;
}

} // namespace stltsa::phase
