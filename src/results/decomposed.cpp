// SPDX-License-Identifier: BSD-3-Clause
#include "results/decomposed.hpp"

#include <algorithm>
#include <cmath>

#include "base/names.hpp"
#include "base/progress.hpp"
#include "clip/body/course.hpp"
#include "clip/body/heading.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/column_owners.hpp"
#include "clip/features/drift.hpp"
#include "clip/features/features.hpp"
#include "clip/features/points.hpp"
#include "ltsa/frames.hpp"
#include "ltsa/warnings.hpp"
#include "results/postures.hpp"
#include "results/source_frames.hpp"
#include "results/strikes.hpp"

namespace stltsa::results {
namespace {

using motion::Recording;

/// The joints that carry a segment have this share of its motion, and are at most so many.
constexpr double carried_share = 0.5;
constexpr std::size_t most_carriers = 8;

void set_messages(const ClipSamples& prepared, motion::Options& options) {
    const double fps = prepared.source.clips.front().fps;
    options.in_space = prepared.source.samples.features == clip::Features::raw;
    if (prepared.jump > 0) {
        options.jump_s = static_cast<double>(prepared.jump) / fps;
        options.jump = format_text("frame {} ({:.2f} s)", prepared.jump, options.jump_s);
    }
}

/// Units in frames. A unit that rounds to no frame is left out, and its two neighbors become one
/// unit if they are of one kind and segment.
std::vector<stltsa_unit> units_of(const Recording& found, const SourceFrames& frames) {
    std::vector<stltsa_unit> units;
    for (const motion::Unit& unit : found.units) {
        stltsa_unit next{};
        frames.set(unit.begin, unit.end, next);
        next.kind = static_cast<std::int64_t>(unit.kind);
        next.segment = unit.segment;
        if (!units.empty()) {
            next.begin = units.back().end;
            next.begin_s = units.back().end_s;
        }
        if (next.end <= next.begin) {
            if (!units.empty() && units.back().segment == next.segment)
                units.back().end_s = next.end_s;
            continue;
        }
        if (!units.empty() && units.back().kind == next.kind &&
            units.back().segment == next.segment) {
            units.back().end = next.end;
            units.back().end_s = next.end_s;
        } else {
            units.push_back(next);
        }
    }
    frames.cover_recorded(units);
    return units;
}

/// The names that own most of the motion, in decreasing order.
std::vector<std::string> carriers_of(const std::vector<double>& energy,
                                     const std::vector<std::string>& owners) {
    std::vector<std::pair<double, std::string>> shares;
    double total = 0;
    for (std::size_t c = 0; c < energy.size() && c < owners.size(); ++c) {
        if (shares.empty() || shares.back().second != owners[c])
            shares.emplace_back(0, owners[c]);
        shares.back().first -= energy[c];
        total += energy[c];
    }
    std::stable_sort(shares.begin(), shares.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> carriers;
    double carried = 0;
    for (const auto& [share, name] : shares) {
        if (!(carried < carried_share * total) || carriers.size() == most_carriers)
            break;
        carriers.push_back(name);
        carried -= share;
    }
    return carriers;
}

stltsa_segment segment_of(const motion::Segment& found, const SourceFrames& frames,
                          const std::vector<std::string>& owners, Texts& texts) {
    const auto known = [](double seconds) { return seconds > 0 ? seconds : none; };
    stltsa_segment segment{};
    frames.set(found.begin, found.end, segment);
    segment.kind = static_cast<std::int64_t>(found.kind);
    segment.label = found.label;
    segment.letters = texts.keep(letters_of(found.label));
    segment.count = found.count;
    segment.likeness = found.likeness;
    segment.period_s = known(frames.seconds(found.period));
    segment.candidate_period_s = known(frames.seconds(found.candidate_period));
    segment.carried_by = texts.keep(carriers_of(found.energy, owners));
    segment.confidence = found.confidence;
    segment.begin_confidence = found.begin_confidence;
    segment.open_begin = found.open_begin ? 1 : 0;
    segment.open_end = found.open_end ? 1 : 0;
    segment.reason = texts.keep(found.reason);
    segment.first_step_share = found.halves.first;
    segment.first_step_margin = found.halves.margin;
    segment.steps_reason = texts.keep(found.halves.reason);
    return segment;
}

const char* name_of(Side side) {
    return side == Side::left ? "left" : side == Side::right ? "right" : "";
}

/// How the body moves over the ground.
class Ground {
  public:
    Ground(const clip::Clip& clip, const SampleFacts& samples)
        : points_(!clip.skeleton && samples.features == clip::Features::points),
          course_(clip, points_ ? samples.up : default_up(clip),
                  points_ ? clip::point_columns(clip) : 0),
          fps_(clip.fps) {}

    void set(stltsa_part& part) const {
        const clip::Travel found = course_.between(part.begin_s * fps_, part.end_s * fps_);
        part.path_length = found.way;
        part.stride = found.stride;
        part.speed = found.way / (part.end_s - part.begin_s);
        part.turn_deg = found.turn;
    }

  private:
    bool points_;
    clip::Course course_;
    double fps_;
};

template <class Found>
stltsa_part part_of(const Found& found, const SourceFrames& frames, const Decomposed& made) {
    const stltsa_segment& segment = made.segments[static_cast<std::size_t>(found.segment)];
    stltsa_part part{};
    frames.set(found.begin, found.end, part);
    part.segment = found.segment;
    part.cycle = -1;
    part.label = segment.label;
    part.letters = segment.letters;
    part.side = -1;
    part.side_name = "";
    return part;
}

void set_parts(const Recording& found, const SourceFrames& frames, Decomposed& made) {
    for (const motion::Cycle& cycle : found.cycles) {
        stltsa_part part = part_of(cycle, frames, made);
        part.side = cycle.side;
        part.side_name = name_of(made.named_side(cycle.side));
        part.likeness = cycle.likeness;
        part.confidence = cycle.confidence;
        made.cycles.push_back(part);
    }
    for (const motion::Step& step : found.steps) {
        const stltsa_part& cycle = made.cycles[static_cast<std::size_t>(step.cycle)];
        stltsa_part part = part_of(step, frames, made);
        part.cycle = step.cycle;
        part.side = step.side;
        part.side_name = name_of(made.named_side(step.side));
        part.likeness = cycle.likeness;
        part.confidence = cycle.confidence;
        made.steps.push_back(part);
    }
    for (const motion::Repetition& repetition : found.repetitions) {
        stltsa_part part = part_of(repetition, frames, made);
        part.likeness = repetition.likeness;
        part.confidence = repetition.confidence;
        made.repetitions.push_back(part);
    }
}

void set_segments(const Recording& found, const SourceFrames& frames, Decomposed& made) {
    for (const motion::Segment& segment : found.segments)
        made.segments.push_back(segment_of(segment, frames, made.rows->owners, made.texts));
    frames.cover_recorded(made.segments);
}

/// The strikes in samples, with the numbers of the sides.
std::vector<motion::Strikes> in_samples(const FoundStrikes& found, const SourceFrames& frames,
                                        Side side_one) {
    std::vector<motion::Strikes> all;
    for (const MotionStrikes& motion : found.motions) {
        motion::Strikes strikes{static_cast<int>(motion.label), -1, motion.begins, motion.middles};
        if (motion.side != Side::neither)
            strikes.side = motion.side == side_one ? 1 : 0;
        for (std::vector<double>* places : {&strikes.begins, &strikes.middles})
            for (double& place : *places)
                place = frames.sample(place);
        all.push_back(std::move(strikes));
    }
    return all;
}

/// The frames before the body comes and after it has left are rests with this reason.
void add_unrecorded(const SourceFrames& frames, Decomposed& made) {
    const auto add = [&](const clip::Frames& absent, std::int32_t unit_kind, bool first) {
        if (absent.count() == 0)
            return;
        auto segment = frames.interval<stltsa_segment>(absent);
        segment.kind = STLTSA_SEGMENT_REST;
        segment.label = -1;
        segment.confidence = 1;
        segment.likeness = none;
        segment.begin_confidence = first ? none : 1;
        segment.letters = segment.steps_reason = "";
        segment.period_s = segment.candidate_period_s = none;
        segment.first_step_share = segment.first_step_margin = none;
        segment.carried_by = made.texts.keep(std::vector<std::string>());
        segment.reason = motion::nothing_recorded;
        auto unit = frames.interval<stltsa_unit>(absent);
        unit.kind = unit_kind;
        unit.segment = first ? 0 : std::ssize(made.segments);
        const auto at = [first](auto& all) { return first ? all.begin() : all.end(); };
        made.segments.insert(at(made.segments), segment);
        made.units.insert(at(made.units), unit);
    };
    const clip::Frames& recorded = frames.recorded();
    if (recorded.begin > 0) {
        made.segments.front().begin_confidence = 1;
        const auto shift = [](auto& all) {
            for (auto& each : all)
                ++each.segment;
        };
        shift(made.units);
        shift(made.cycles);
        shift(made.steps);
        shift(made.repetitions);
    }
    add({0, recorded.begin}, STLTSA_UNIT_PREPARING, true);
    add({recorded.end, made.source.clips.front().frames}, STLTSA_UNIT_WIND_UP, false);
}

double period_of_longest(const std::vector<stltsa_segment>& segments) {
    double longest = 0, period = 0;
    for (const stltsa_segment& segment : segments)
        if (segment.kind == STLTSA_SEGMENT_CYCLIC && segment.end_s - segment.begin_s > longest) {
            longest = segment.end_s - segment.begin_s;
            period = std::isnan(segment.period_s) ? 0 : segment.period_s;
        }
    return period;
}

/// Norm of the mean pose if the samples are positions relative to the body; 0 otherwise.
double body_size(clip::Features features, const Matrix& samples) {
    if (features != clip::Features::positions && features != clip::Features::points)
        return 0;
    double squares = 0;
    for (std::int64_t c = 0; c < samples.cols(); ++c) {
        double mean = 0;
        for (std::int64_t i = 0; i < samples.rows(); ++i)
            mean += samples(i, c) / static_cast<double>(samples.rows());
        squares += mean * mean;
    }
    return std::sqrt(squares);
}

/// The rotations of the joints in each sample, if the samples are their positions. They are not
/// smoothed.
Matrix rotations_beside(const clip::Clip& clip, const SampleFacts& samples) {
    if (samples.features != clip::Features::positions ||
        clip::turning_joints(*clip.skeleton, clip::body_root(clip)).empty())
        return {};
    clip::Clip kept;
    kept.fps = samples.fps;
    kept.skeleton = clip.skeleton;
    kept.values = Matrix::unset(samples.count, clip.values.cols());
    for (std::int64_t i = 0; i < samples.count; ++i)
        std::copy_n(clip.values.row(samples.first + i * samples.step), clip.values.cols(),
                    kept.values.row(i));
    return clip::feature_rows(kept, clip::Features::rotations6d, samples.up, clip::GapRule::fill)
        .rows;
}

/// Says which columns drifted.
void note_drift(const clip::Clip& clip, clip::Features features,
                const std::vector<std::int64_t>& columns, std::vector<std::string>& notes) {
    constexpr std::size_t most_named = 6;
    const auto owners = clip::column_owners(clip, features);
    std::vector<std::string> names;
    for (const std::int64_t column : columns)
        if (const std::string& name = owners[static_cast<std::size_t>(column)];
            names.empty() || names.back() != name)
            names.push_back(name);
    if (names.empty())
        return;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i)
        text += (i == 0 ? "" : ", ") + names[i];
    if (names.size() > most_named)
        text += format_text(" and {} more", names.size() - most_named);
    notes.push_back(
        format_text("columns that only drift, whose slow part was subtracted: {}", text));
}

/// In samples.
std::vector<motion::Hole> holes_of(const ClipSamples& prepared) {
    const SampleFacts& samples = prepared.source.samples;
    const auto sample = [&](std::int64_t frame) {
        return std::max(0.0, static_cast<double>(frame - samples.first) /
                                 static_cast<double>(samples.step));
    };
    std::vector<motion::Hole> holes;
    for (const clip::Frames& hole : prepared.holes)
        if (hole.end > samples.first && hole.end < prepared.source.clips.front().frames)
            holes.push_back({sample(hole.begin), sample(hole.end)});
    return holes;
}

/// Poses come in order of time, but bare numbers may be rows of anything. Read before smoothing,
/// after which neighboring rows are alike in any order.
void warn_of_order(const clip::Clip& clip, clip::Features features, Warnings& warnings) {
    if (features != clip::Features::raw)
        return;
    const std::int64_t rows = clip.values.rows();
    const auto distinct = ltsa::collapse_repeats(clip.values.view(), std::span(&rows, 1), 1);
    if (auto warning = ltsa::order_warning(ltsa::share_in_order(distinct)))
        warnings.push_back(*std::move(warning));
}

std::shared_ptr<const FrameRows> frame_rows(const clip::Clip& clip, const Source& source,
                                            std::vector<double> side,
                                            std::vector<std::int64_t> drifting,
                                            ClipSamples& prepared) {
    const auto made = std::make_shared<FrameRows>();
    made->rows = std::move(prepared.rows);
    made->drifting = std::move(drifting);
    made->clip = source.clips.front();
    made->clip.step = 1;
    made->samples = source.samples;
    made->body = clip::body_of(clip, source.samples.features, source.samples.up, prepared.turned);
    made->side = std::move(side);
    made->owners = clip::column_owners(clip, source.samples.features);
    const auto row = [&](std::int64_t frame) {
        return std::clamp<std::int64_t>(frame - made->clip.first, 0, made->rows.rows());
    };
    for (const clip::Frames& hole : prepared.holes)
        made->holes.push_back({row(hole.begin), row(hole.end)});
    return made;
}

} // namespace

Side Decomposed::named_side(std::int64_t side) const {
    if (side < 0 || side > 1 || side_one == Side::neither)
        return Side::neither;
    return (side == 1) == (side_one == Side::left) ? Side::left : Side::right;
}

std::span<const stltsa_part> Decomposed::parts(std::int32_t kind) const {
    switch (kind) {
    case STLTSA_INFO_CYCLE:
        return cycles;
    case STLTSA_INFO_STEP:
        return steps;
    case STLTSA_INFO_REPETITION:
        return repetitions;
    default:
        return {};
    }
}

Decomposed decompose(const clip::Clip& clip, const clip::PrepareOptions& prepare,
                     motion::Options options) {
    if (!(clip.fps > 0))
        fail(Status::argument, "the frame rate of {} is unknown: open it with option fps",
             clip.path.empty() ? "the clip" : clip.path);
    const clip::Clip* single = &clip;
    clip::PrepareOptions with_rows = prepare;
    with_rows.keep_rows = true;
    ClipSamples prepared = prepare_clips({&single, 1}, with_rows);
    set_messages(prepared, options);
    const SampleFacts& samples = prepared.source.samples;
    const double fps = samples.fps;
    report_progress(Stage::features, 1);
    std::vector<std::int64_t> drifting = clip::remove_drift(prepared.samples, fps);
    note_drift(clip, samples.features, drifting, prepared.source.clips.front().notes);
    if (!drifting.empty())
        drifting = clip::remove_drift(prepared.rows, clip.fps);
    options.smoothed_s = samples.smoothing;
    options.size = body_size(samples.features, prepared.samples);
    options.holes = holes_of(prepared);
    options.rotations = rotations_beside(clip, samples);
    BodySides sides = body_sides(clip, samples, prepared.samples.view());
    options.side = sides.weights;
    options.one_side = std::move(sides.one);
    options.other_side = std::move(sides.other);
    options.forward = sides.forward;
    options.begin_with_side = samples.features != clip::Features::points;
    Decomposed made;
    made.source = std::move(prepared.source);
    made.side_one = sides.name;
    made.rows =
        frame_rows(clip, made.source, std::move(sides.weights), std::move(drifting), prepared);
    const SourceFrames frames(made.source, prepared.holes);
    const auto stated = clip::foot_strikes(clip);
    FoundStrikes strikes;
    if (!stated.empty())
        options.strikes = [&](const Recording& first) {
            Decomposed before;
            before.rows = made.rows;
            before.side_one = made.side_one;
            set_segments(first, frames, before);
            set_parts(first, frames, before);
            strikes = find_strikes(stated, before);
            if (made.side_one == Side::neither && !strikes.motions.empty())
                made.side_one = Side::right; // the file tells the sides if the names do not
            return in_samples(strikes, frames, made.side_one);
        };
    motion::Recording found = motion::analyze(prepared.samples.view(), fps, options);
    note_strikes(strikes, found, made.source.clips.front().notes);
    made.source.period = {found.curve.period / fps, found.curve.lag_quality,
                          options.periods.shortest_s, options.periods.longest_s};
    set_segments(found, frames, made);
    made.units = units_of(found, frames);
    set_parts(found, frames, made);
    add_unrecorded(frames, made);
    const Ground ground(clip, samples);
    for (auto* parts : {&made.cycles, &made.steps, &made.repetitions})
        for (stltsa_part& part : *parts)
            ground.set(part);
    for (const std::int64_t row : telling_postures(prepared.samples.view()))
        made.postures.push_back(made.source.samples.first + row * made.source.samples.step);
    made.source.period.period = period_of_longest(made.segments);
    made.summaries = summaries_of(made.cycles, made.steps, made.repetitions);
    made.label_likeness = std::move(found.label_likeness);
    made.curve = std::move(found.curve);
    made.representative = found.representative;
    made.best = found.best;
    made.reason = std::move(found.reason);
    made.warnings = std::move(found.warnings);
    warn_of_order(clip, made.source.samples.features, made.warnings);
    return made;
}

} // namespace stltsa::results
