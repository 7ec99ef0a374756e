// SPDX-License-Identifier: BSD-3-Clause
#include "results/events.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/progress.hpp"
#include "phase/events.hpp"

namespace stltsa::results {
namespace {

/// A phase is continued so far beyond the cycles, in cycles: to the slow last steps of a walk.
constexpr double most_beyond = 2.5;
/// Mean cycles less alike than this are of other motions: walks of several people have 0.89 and
/// more.
constexpr double least_likeness = 0.6;
/// Error at which an event is as likely wrong as right, in milliseconds.
constexpr double doubtful_ms = 60;

/// Where a run may grow: up to the next run of any motion; cycles within motion, a repetition also
/// into the rests around it, as its ends are often marked.
motion::Range room_of(const Phased& phased, const PhasedMotion& motion, const motion::Run& run) {
    motion::Range room{run.begin, run.end()};
    if (!motion.phases.cyclic)
        room = unbroken(phased, run);
    for (const motion::Range& moving : phased.moving)
        if (motion.phases.cyclic && moving.begin <= run.begin && run.end() <= moving.end)
            room = moving;
    for (const PhasedMotion& other : phased.motions)
        for (const motion::Run& next : other.phases.runs) {
            if (next.end() <= run.begin)
                room.begin = std::max(room.begin, next.end());
            if (next.begin >= run.end())
                room.end = std::min(room.end, next.begin);
        }
    const double most = motion.phases.cyclic ? most_beyond : 0.25;
    const auto beyond = static_cast<std::int64_t>(std::ceil(most * motion.phases.mean.period));
    return {std::max(room.begin, run.begin - beyond), std::min(room.end, run.end() + beyond)};
}

/// The marks of a motion.
struct Marked {
    phase::Searched motion;
    std::vector<phase::Mark> marks;
};

void add_mark(double frame, double row, std::vector<Marked>& motions) {
    for (Marked& each : motions)
        if (const auto mark = phase::mark_at(each.motion, row);
            mark && mark->distance <= phase::other_motion) {
            each.marks.push_back(*mark);
            return;
        }
    fail(Status::argument,
         "the mark at frame {} lies in no motion that repeats: mark a frame in a cycle or a "
         "repetition",
         frame);
}

std::vector<Marked> marked_motions(const Phased& from, std::span<const double> marks) {
    std::vector<Marked> all;
    for (const PhasedMotion& motion : from.motions)
        all.push_back({searched(from, motion), {}});
    for (const double mark : marks)
        add_mark(mark, mark - static_cast<double>(from.clip.first), all);
    std::erase_if(all, [](const Marked& each) { return each.marks.empty(); });
    return all;
}

double confidence_of(double error_ms) {
    const double share = error_ms / doubtful_ms;
    return 1 / (1 + share * share);
}

std::int64_t cycle_at(const Phased& in, double frame) {
    const auto at = static_cast<std::int64_t>(std::floor(frame));
    return at >= 0 && at < in.clip.frames ? in.cycle[static_cast<std::size_t>(at)] : -1;
}

std::vector<stltsa_event> found_in(const std::vector<phase::Event>& events, const Phased& in) {
    std::vector<stltsa_event> found;
    for (const phase::Event& event : events) {
        const double frame = event.row + static_cast<double>(in.clip.first);
        found.push_back({frame, frame / in.clip.fps, cycle_at(in, frame),
                         confidence_of(event.error_ms), false});
    }
    return found;
}

/// Each mark itself, in place of what was found near it.
void set_marked(const phase::Place& marks, double period, const Phased& in,
                std::vector<stltsa_event>& found) {
    for (const phase::Mark& mark : marks) {
        const double frame = mark.row + static_cast<double>(in.clip.first);
        const auto off = [&](const stltsa_event& event) {
            return event.marked ? period : std::abs(event.frame - frame);
        };
        const auto nearest = std::ranges::min_element(found, {}, off);
        const stltsa_event marked{frame, frame / in.clip.fps, cycle_at(in, frame), 1, true};
        if (nearest != found.end() && off(*nearest) < period / 4)
            *nearest = marked;
        else
            found.push_back(marked);
    }
}

void append(std::vector<stltsa_event> events, FoundEvents& found) {
    std::ranges::move(events, std::back_inserter(found.events));
}

void check_features(const Phased& from, const Phased& in) {
    if (from.rows.cols() != in.rows.cols() || from.samples.features != in.samples.features)
        fail(Status::shape,
             "the clips have other features ({} and {} columns): events are found in clips of the "
             "same skeleton or the same points",
             from.rows.cols(), in.rows.cols());
}

void warn_of_repetitions(const phase::Searched& in, std::size_t events, FoundEvents& found) {
    if (!in.cyclic && events < in.runs.size())
        found.warnings.push_back(
            {WarningCode::not_found,
             format_text("{} of {} repetitions have no such event: the clip ends before it, or the "
                         "motion differs there",
                         in.runs.size() - events, in.runs.size())});
}

void append_other(const phase::Searched& from, const std::vector<phase::Place>& places,
                  const Phased& in, FoundEvents& found) {
    for (const PhasedMotion& motion : in.motions) {
        if (motion.phases.cyclic != from.cyclic)
            continue;
        const phase::Searched target = searched(in, motion);
        const double alike = phase::likeness(from, target);
        found.likeness = std::max(found.likeness, alike);
        if (alike < least_likeness)
            continue;
        for (const phase::Place& place : places) {
            auto events = found_in(phase::find_events(from, place, target), in);
            warn_of_repetitions(target, events.size(), found);
            append(std::move(events), found);
        }
    }
}

void append_same(const phase::Searched& motion, const std::vector<phase::Place>& places,
                 const Phased& in, FoundEvents& found) {
    for (const phase::Place& place : places) {
        auto events = found_in(phase::find_events(motion, place), in);
        warn_of_repetitions(motion, events.size(), found);
        set_marked(place, motion.mean.period, in, events);
        append(std::move(events), found);
    }
}

void warn_of_places(std::size_t places, bool cyclic, FoundEvents& found) {
    if (places > 1)
        found.warnings.push_back(
            {WarningCode::several_places,
             format_text("the marks lie at {} places in the {}: each place is found separately; if "
                         "these are different events, give each a name of its own",
                         places, cyclic ? "cycle" : "repetition")});
}

} // namespace

phase::Searched searched(const Phased& phased, const PhasedMotion& motion) {
    report_progress(Stage::units, 0);
    const motion::MeanCycle& mean = motion.phases.mean;
    const Matrix both = motion::pose_and_velocity(phased.rows.view(), phased.clip.fps, mean.period);
    std::vector<motion::Run> runs;
    for (const motion::Run& run : motion.phases.runs) {
        const motion::Range room = room_of(phased, motion, run);
        runs.push_back(motion.phases.linear ? motion::continued(run, mean.period, room)
                                            : motion::grown(both.view(), mean, run, room));
    }
    return phase::searched(phased.rows.view(), both.view(), phased.clip.fps, motion.phases,
                           std::move(runs));
}

std::vector<stltsa_event> events_at(const phase::Searched& motion, const phase::Place& marks,
                                    const Phased& in) {
    auto events = found_in(phase::find_events(motion, marks), in);
    set_marked(marks, motion.mean.period, in, events);
    return events;
}

FoundEvents find_events(const Phased& from, std::span<const double> marks, const Phased& in) {
    check_features(from, in);
    const bool same = &from == &in;
    FoundEvents found;
    if (!same)
        found.likeness = 0;
    found.warnings = in.warnings;
    if (!same)
        std::ranges::copy(from.warnings, std::back_inserter(found.warnings));
    for (const Marked& marked : marked_motions(from, marks)) {
        const auto places = phase::places_of(marked.motion, marked.marks);
        warn_of_places(places.size(), marked.motion.cyclic, found);
        if (same)
            append_same(marked.motion, places, in, found);
        else
            append_other(marked.motion, places, in, found);
    }
    std::ranges::sort(found.events, {}, &stltsa_event::frame);
    return found;
}

} // namespace stltsa::results
