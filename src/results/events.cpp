// SPDX-License-Identifier: BSD-3-Clause
#include "results/events.hpp"

#include <algorithm>
#include <cmath>
#include <map>

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

/// Where a run may grow: within motion, up to the next run of any motion.
phase::Range room_of(const Phased& phased, const PhasedMotion& motion, const phase::Run& run) {
    phase::Range room{run.begin, run.end()};
    for (const phase::Range& moving : phased.moving)
        if (moving.begin <= run.begin && run.end() <= moving.end)
            room = moving;
    for (const PhasedMotion& other : phased.motions)
        for (const phase::Run& next : other.phases.runs) {
            if (next.end() <= run.begin)
                room.begin = std::max(room.begin, next.end());
            if (next.begin >= run.end())
                room.end = std::min(room.end, next.begin);
        }
    const double most = motion.phases.cyclic ? most_beyond : 0.25;
    const auto beyond = static_cast<std::int64_t>(std::ceil(most * motion.phases.mean.period));
    return {std::max(room.begin, run.begin - beyond), std::min(room.end, run.end() + beyond)};
}

phase::Searched searched(const Phased& phased, const PhasedMotion& motion) {
    const phase::MeanCycle& mean = motion.phases.mean;
    const Matrix both = phase::pose_and_velocity(phased.rows.view(), phased.clip.fps, mean.period);
    std::vector<phase::Run> runs;
    for (const phase::Run& run : motion.phases.runs) {
        const phase::Range room = room_of(phased, motion, run);
        runs.push_back(motion.phases.linear ? phase::continued(run, mean.period, room)
                                            : phase::grown(both.view(), mean, run, room));
    }
    return phase::searched(phased.rows.view(), phased.clip.fps, motion.phases, std::move(runs));
}

bool holds(const phase::Searched& motion, double row) {
    return std::ranges::any_of(motion.runs, [&](const phase::Run& run) {
        return row >= static_cast<double>(run.begin) && row <= static_cast<double>(run.end() - 1);
    });
}

/// The marks of each motion, in rows.
struct Marked {
    phase::Searched motion;
    std::vector<double> rows;
};

std::vector<Marked> marked_motions(const Phased& from, std::span<const double> marks) {
    std::vector<Marked> all;
    for (const PhasedMotion& motion : from.motions)
        all.push_back({searched(from, motion), {}});
    for (const double mark : marks) {
        const double row = mark - static_cast<double>(from.clip.first);
        const auto found =
            std::ranges::find_if(all, [&](const Marked& each) { return holds(each.motion, row); });
        if (found == all.end())
            fail(Status::argument,
                 "the mark at frame {} lies in no motion that repeats: mark a frame in a cycle or "
                 "a repetition",
                 mark);
        found->rows.push_back(row);
    }
    std::erase_if(all, [](const Marked& each) { return each.rows.empty(); });
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

void append(const std::vector<phase::Event>& events, const Phased& in, FoundEvents& found) {
    for (const phase::Event& event : events) {
        const double frame = event.row + static_cast<double>(in.clip.first);
        found.events.push_back({frame, frame / in.clip.fps, cycle_at(in, frame),
                                confidence_of(event.error_ms), false});
    }
}

/// The marks themselves, in place of what was found there.
void set_marked(std::span<const double> marks, const Phased& in, FoundEvents& found) {
    for (const double mark : marks) {
        const auto nearest =
            std::ranges::min_element(found.events, {}, [&](const FoundEvent& event) {
                return std::abs(event.frame - mark);
            });
        if (nearest == found.events.end())
            continue;
        *nearest = {mark, mark / in.clip.fps, cycle_at(in, mark), 1, true};
    }
}

void check_features(const Phased& from, const Phased& in) {
    if (from.rows.cols() != in.rows.cols() || from.samples.features != in.samples.features)
        fail(Status::shape,
             "the clips have other features ({} and {} columns): events are found in clips of the "
             "same skeleton or the same points",
             from.rows.cols(), in.rows.cols());
}

} // namespace

FoundEvents find_events(const Phased& from, std::span<const double> marks, const Phased& in) {
    check_features(from, in);
    const bool same = &from == &in;
    FoundEvents found;
    if (!same)
        found.likeness = 0;
    for (const Marked& marked : marked_motions(from, marks)) {
        if (same) {
            append(phase::find_events(marked.motion, marked.rows), in, found);
            continue;
        }
        for (const PhasedMotion& motion : in.motions) {
            if (motion.phases.cyclic != marked.motion.cyclic)
                continue;
            const phase::Searched target = searched(in, motion);
            const double alike = phase::likeness(marked.motion, target);
            found.likeness = std::max(found.likeness, alike);
            if (alike >= least_likeness)
                append(phase::find_events(marked.motion, marked.rows, target), in, found);
        }
    }
    std::ranges::sort(found.events, {}, &FoundEvent::frame);
    if (same)
        set_marked(marks, in, found);
    return found;
}

} // namespace stltsa::results
