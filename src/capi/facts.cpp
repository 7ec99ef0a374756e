// SPDX-License-Identifier: BSD-3-Clause
// The facts of each kind of handle.
#include <algorithm>
#include <array>
#include <numbers>

#include "base/numbers.hpp"
#include "capi/compared_rows.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "clip/body/skeleton.hpp"

using namespace stltsa;

namespace stltsa::capi {
namespace {

// ---- Where the rows come from ----

/// The notes of all clips, one after another.
struct Notes {
    const std::vector<ClipFacts>& clips;

    std::size_t size() const {
        std::size_t count = 0;
        for (const ClipFacts& clip : clips)
            count += clip.notes.size();
        return count;
    }
    const std::string& operator[](std::size_t index) const {
        auto clip = clips.begin();
        for (; index >= clip->notes.size(); ++clip)
            index -= clip->notes.size();
        return clip->notes[index];
    }
};

struct Place {
    std::int64_t first = 0;
    std::int64_t step = 1;
};

/// The place of the rows of each clip; rows of a matrix are its frames.
struct Places {
    const std::vector<ClipFacts>& clips;

    std::size_t size() const { return std::max<std::size_t>(clips.size(), 1); }
    Place operator[](std::size_t index) const {
        return clips.empty() ? Place{} : Place{clips[index].first, clips[index].step};
    }
};

const PeriodFacts& found_period(const stltsa_denoising& denoising) {
    return denoising.period;
}
template <class Handle>
const PeriodFacts& found_period(const Handle& handle) {
    return handle.source.period;
}

template <class Handle>
PeriodFacts period_of(const Handle& handle) {
    return in_seconds(found_period(handle), handle.source.samples);
}

template <class H>
constexpr InfoRow source_rows[] = {
    each<H>(
        STLTSA_INFO_PATH, [](const H& h) -> const auto& { return h.source.clips; },
        [](const ClipFacts& clip) -> const auto& { return clip.path; }),
    each<H>(
        STLTSA_INFO_FORMAT, [](const H& h) -> const auto& { return h.source.clips; },
        [](const ClipFacts& clip) { return clip.format; }),
    each<H>(
        STLTSA_INFO_CLIP_FRAMES, [](const H& h) -> const auto& { return h.source.clips; },
        [](const ClipFacts& clip) { return clip.frames; }),
    each<H>(
        STLTSA_INFO_CLIP_FPS, [](const H& h) -> const auto& { return h.source.clips; },
        [](const ClipFacts& clip) { return clip.fps; }),
    list<H>(STLTSA_INFO_NOTE, [](const H& h) { return Notes{h.source.clips}; }),
    one<H>(STLTSA_INFO_FEATURES, [](const H& h) { return h.source.samples.features; }),
    one<H>(STLTSA_INFO_FEATURE_COUNT, [](const H& h) { return h.source.samples.feature_count; }),
    one<H>(STLTSA_INFO_UP_AXIS, [](const H& h) { return h.source.samples.up; }),
    one<H>(STLTSA_INFO_SMOOTHING, [](const H& h) { return h.source.samples.smoothing; }),
    one<H>(STLTSA_INFO_ROWS, [](const H& h) { return h.source.samples.count; }),
    each<H>(
        STLTSA_INFO_FIRST_FRAME, [](const H& h) { return Places{h.source.clips}; },
        [](const Place& place) { return place.first; }),
    each<H>(
        STLTSA_INFO_FRAME_STEP, [](const H& h) { return Places{h.source.clips}; },
        [](const Place& place) { return place.step; }),
    one<H>(STLTSA_INFO_FPS, [](const H& h) { return h.source.samples.fps; }),
    one<H>(STLTSA_INFO_PERIOD, [](const H& h) { return period_of(h).period; }),
    one<H>(STLTSA_INFO_PERIOD_ROWS,
           [](const H& h) { return rows_of_period(found_period(h), h.source.samples); }),
    one<H>(STLTSA_INFO_LAG_QUALITY, [](const H& h) { return period_of(h).lag_quality; }),
    one<H>(STLTSA_INFO_PERIOD_MIN, [](const H& h) { return period_of(h).shortest; }),
    one<H>(STLTSA_INFO_PERIOD_MAX, [](const H& h) { return period_of(h).longest; }),
};

// ---- The fit ----

const ltsa::Parameters* fit_of(const stltsa_model& model) {
    return &model.model.parameters;
}
const ltsa::Parameters* fit_of(const stltsa_decomposition& decomposition) {
    return decomposition.curve.coordinate > 0 ? &decomposition.curve.parameters : nullptr;
}
const ltsa::Parameters* fit_of(const stltsa_denoising& denoising) {
    return denoising.fit ? &*denoising.fit : nullptr;
}

template <class H, class Get>
constexpr InfoRow of_fit(std::int32_t key, Get get) {
    return maybe<H>(
        key, [](const H& h) { return fit_of(h); }, get);
}

template <class H>
constexpr InfoRow fit_rows[] = {
    of_fit<H>(STLTSA_INFO_MODE, [](const ltsa::Parameters& p) { return p.mode; }),
    of_fit<H>(STLTSA_INFO_NEIGHBORS, [](const ltsa::Parameters& p) { return p.neighbors; }),
    of_fit<H>(STLTSA_INFO_WINDOW, [](const ltsa::Parameters& p) { return p.window; }),
    of_fit<H>(STLTSA_INFO_DIMENSION, [](const ltsa::Parameters& p) { return p.dimension; }),
    of_fit<H>(STLTSA_INFO_INCLUDE_SELF, [](const ltsa::Parameters& p) { return p.include_self; }),
    of_fit<H>(STLTSA_INFO_LINKS, [](const ltsa::Parameters& p) { return p.links; }),
    of_fit<H>(STLTSA_INFO_EXCLUSION, [](const ltsa::Parameters& p) { return p.exclusion; }),
};

// ---- Warnings ----

const Warnings& warnings_of(const stltsa_model& model) {
    return model.model.warnings;
}
const Warnings& warnings_of(const stltsa_phase& phase) {
    return phase.found->warnings;
}
const Warnings& warnings_of(const stltsa_synthesis& synthesis) {
    return synthesis.result.warnings;
}
template <class Handle>
const Warnings& warnings_of(const Handle& handle) {
    return handle.warnings;
}

template <class H>
constexpr InfoRow warning_rows[] = {
    rows<H>(
        STLTSA_INFO_WARNING, [](const H& h) { return warnings_of(h).size(); },
        [](const H& h, std::size_t index) {
            const Warning& found = warnings_of(h)[index];
            return stltsa_warning{static_cast<std::int64_t>(found.code), found.text.c_str(),
                                  found.begin_s, found.end_s};
        }),
};

// ---- Clips ----

using Clip = stltsa_clip;

constexpr auto joint_count = [](const Clip& c) {
    return c.clip.skeleton ? c.clip.skeleton->joints.size() : 0;
};

constexpr auto joint_at = [](const Clip& c, std::size_t index) {
    const clip::Joint& joint = c.clip.skeleton->joints[index];
    stltsa_joint row{};
    row.name = joint.name.c_str();
    row.parent = joint.parent;
    std::ranges::copy(joint.offset, row.offset);
    row.channels = c.channels.empty() ? nullptr : c.channels[index].c_str();
    row.is_end_site = joint.end_site ? 1 : 0;
    return row;
};

/// An array with so many columns for each joint; none without a skeleton.
template <std::int64_t columns, class Get>
constexpr InfoRow of_joints(std::int32_t key, Get) {
    return arrays<Clip>(
        key, false, [](const Clip& c) { return c.clip.skeleton ? 1 : 0; },
        [](const Clip& c) {
            return Shape{c.clip.frames(), columns * static_cast<std::int64_t>(joint_count(c))};
        },
        [](const Clip& c, std::size_t) { return Get{}(c); });
}

constexpr InfoRow clip_rows[] = {
    one<Clip>(
        STLTSA_INFO_PATH, [](const Clip& c) -> const auto& { return c.clip.path; }),
    one<Clip>(STLTSA_INFO_FORMAT, [](const Clip& c) { return c.clip.format; }),
    one<Clip>(STLTSA_INFO_CLIP_FRAMES, [](const Clip& c) { return c.clip.frames(); }),
    one<Clip>(STLTSA_INFO_CLIP_FPS, [](const Clip& c) { return c.clip.fps; }),
    list<Clip>(
        STLTSA_INFO_NOTE, [](const Clip& c) -> const auto& { return c.clip.notes; }),
    list<Clip>(
        STLTSA_INFO_CHANNEL, [](const Clip& c) -> const auto& { return c.clip.channel_names; }),
    one<Clip>(STLTSA_INFO_FEATURES, [](const Clip& c) { return default_features(c.clip); }),
    one<Clip>(STLTSA_INFO_UP_AXIS, [](const Clip& c) { return default_up(c.clip); }),
    one<Clip>(STLTSA_INFO_FIRST_FRAME, [](const Clip& c) { return default_first_frame(c.clip); }),
    one<Clip>(STLTSA_INFO_BODY_ROOT, [](const Clip& c) { return default_root(c.clip); }),
    one<Clip>(
        STLTSA_INFO_LENGTH_UNIT, [](const Clip& c) -> const auto& { return c.clip.unit; }),
    one<Clip>(STLTSA_INFO_FILE_UP_AXIS, [](const Clip& c) { return c.clip.up; }),
    rows<Clip>(STLTSA_INFO_JOINT, joint_count, joint_at),
    rows<Clip>(
        STLTSA_INFO_FILE_EVENT, [](const Clip& c) { return c.clip.events.size(); },
        [](const Clip& c, std::size_t index) {
            const clip::Event& at = c.clip.events[index];
            return stltsa_file_event{at.label.c_str(), at.context.c_str(), at.frame,
                                     c.clip.fps > 0 ? at.frame / c.clip.fps : none};
        }),
    one<Clip>(STLTSA_INFO_CHANNELS, [](const Clip& c) { return c.clip.values.cols(); }),
    of_joints<3>(STLTSA_INFO_POSITIONS, [](const Clip& c) { return clip::positions(c.clip); }),
    of_joints<4>(STLTSA_INFO_ROTATIONS, [](const Clip& c) { return clip::rotations(c.clip); }),
};

// ---- Models ----

using Model = stltsa_model;

/// The eigenvalues of each component, which has a row.
Matrix eigenvalues_of(const Model& m) {
    const auto& components = m.model.components;
    Matrix all(std::ssize(components), m.model.parameters.dimension + 2);
    for (std::size_t c = 0; c < components.size(); ++c)
        std::copy_n(components[c].eigenvalues.begin(), all.cols(),
                    all.row(static_cast<std::int64_t>(c)));
    return all;
}

template <class Get>
constexpr InfoRow of_dimension(std::int32_t key, Get get) {
    return maybe<Model>(
        key, [](const Model& m) { return m.dimension ? &*m.dimension : nullptr; }, get);
}

/// A list of the estimate of the dimension.
template <std::vector<double> ltsa::Dimension::*list>
constexpr InfoRow dimension_list(std::int32_t key) {
    return {key, true,
            [](const stltsa_info& info) {
                const auto& found = handle_of<Model>(info).dimension;
                return found ? std::ssize((*found).*list) : 0;
            },
            [](const stltsa_info& info, std::size_t index) {
                return fact(((*handle_of<Model>(info).dimension).*list)[index]);
            }};
}

constexpr InfoRow model_rows[] = {
    list<Model>(
        STLTSA_INFO_LENGTH, [](const Model& m) -> const auto& { return m.lengths; }),
    one<Model>(STLTSA_INFO_REPEATED, [](const Model& m) { return m.model.repeated_frames; }),
    one<Model>(STLTSA_INFO_TIME_CORRELATION,
               [](const Model& m) { return m.model.time_correlation; }),
    one<Model>(STLTSA_INFO_REACH,
               [](const Model& m) {
                   const ltsa::Mapping* mapping = mapping_of(m);
                   return mapping == nullptr ? 0 : mapping->reach();
               }),
    rows<Model>(
        STLTSA_INFO_COMPONENT, [](const Model& m) { return m.model.components.size(); },
        [](const Model& m, std::size_t index) {
            const ltsa::Component& c = m.model.components[index];
            return stltsa_component{
                c.frames, c.residual, c.error_estimate, c.gap, c.rank_deficient_windows, c.solves};
        }),
    one<Model>(STLTSA_INFO_HAS_CYCLE, [](const Model& m) { return m.live.has_cycle; }),
    array<Model>(
        STLTSA_INFO_COORDS, [](const Model& m) -> const auto& { return m.model.coords; }),
    arrays<Model>(
        STLTSA_INFO_EIGENVALUES, false, [](const Model&) { return 1; },
        [](const Model& m) { return shape_of(eigenvalues_of(m)); },
        [](const Model& m, std::size_t) { return eigenvalues_of(m); }),
    array<Model>(
        STLTSA_INFO_COMPONENT_OF,
        [](const Model& m) -> const auto& { return m.model.component_of; }),
    of_dimension(STLTSA_INFO_LOCAL_PCA, [](const ltsa::Dimension& d) { return d.local_pca; }),
    of_dimension(STLTSA_INFO_EIGENGAP, [](const ltsa::Dimension& d) { return d.eigengap; }),
    of_dimension(
        STLTSA_INFO_LOCAL_PCA_REASON,
        [](const ltsa::Dimension& d) -> const auto& { return d.local_pca_reason; }),
    of_dimension(
        STLTSA_INFO_EIGENGAP_REASON,
        [](const ltsa::Dimension& d) -> const auto& { return d.eigengap_reason; }),
    of_dimension(STLTSA_INFO_VARIANCE, [](const ltsa::Dimension& d) { return d.local_variance; }),
    of_dimension(STLTSA_INFO_EIGENGAP_THRESHOLD,
                 [](const ltsa::Dimension& d) { return d.threshold; }),
    dimension_list<&ltsa::Dimension::eigenvalues>(STLTSA_INFO_EIGENVALUE),
    dimension_list<&ltsa::Dimension::local_variances>(STLTSA_INFO_LOCAL_VARIANCE),
};

// ---- Decompositions ----

using Decomposition = stltsa_decomposition;

constexpr InfoRow decomposition_rows[] = {
    one<Decomposition>(STLTSA_INFO_COORDINATE,
                       [](const Decomposition& d) { return d.curve.coordinate; }),
    one<Decomposition>(STLTSA_INFO_CYCLICITY,
                       [](const Decomposition& d) { return d.curve.cyclicity; }),
    one<Decomposition>(STLTSA_INFO_REPRESENTATIVE,
                       [](const Decomposition& d) { return d.representative; }),
    one<Decomposition>(STLTSA_INFO_BEST, [](const Decomposition& d) { return d.best; }),
    one<Decomposition>(
        STLTSA_INFO_REASON, [](const Decomposition& d) -> const auto& { return d.reason; }),
    list<Decomposition>(
        STLTSA_INFO_POSTURES, [](const Decomposition& d) -> const auto& { return d.postures; }),
    list<Decomposition>(
        STLTSA_INFO_EIGENVALUE,
        [](const Decomposition& d) -> const auto& { return d.curve.eigenvalues; }),
    rows<Decomposition>(
        STLTSA_INFO_SEGMENT, [](const Decomposition& d) -> const auto& { return d.segments; }),
    rows<Decomposition>(
        STLTSA_INFO_UNIT, [](const Decomposition& d) -> const auto& { return d.units; }),
    rows<Decomposition>(
        STLTSA_INFO_CYCLE, [](const Decomposition& d) -> const auto& { return d.cycles; }),
    rows<Decomposition>(
        STLTSA_INFO_STEP, [](const Decomposition& d) -> const auto& { return d.steps; }),
    rows<Decomposition>(
        STLTSA_INFO_REPETITION,
        [](const Decomposition& d) -> const auto& { return d.repetitions; }),
    rows<Decomposition>(
        STLTSA_INFO_SUMMARY, [](const Decomposition& d) -> const auto& { return d.summaries; }),
    list<Decomposition>(STLTSA_INFO_SIDE,
                        [](const Decomposition& d) {
                            return std::array{d.named_side(0), d.named_side(1)};
                        }),
    array<Decomposition>(
        STLTSA_INFO_CURVE, [](const Decomposition& d) -> const auto& { return d.curve.curve; }),
    array<Decomposition>(
        STLTSA_INFO_COORDS, [](const Decomposition& d) -> const auto& { return d.curve.coords; }),
    array<Decomposition>(
        STLTSA_INFO_LABEL_LIKENESS,
        [](const Decomposition& d) -> const auto& { return d.label_likeness; }),
};

// ---- Phases ----

using Phase = stltsa_phase;

/// Of each label; NaN for one that does not repeat.
struct Zeros {
    const Phased& of;

    std::size_t size() const {
        std::int64_t labels = 0;
        for (const PhasedMotion& motion : of.motions)
            labels = std::max(labels, motion.label + 1);
        return static_cast<std::size_t>(labels);
    }
    double operator[](std::size_t label) const {
        for (const PhasedMotion& motion : of.motions)
            if (motion.label == static_cast<std::int64_t>(label))
                return motion.phases.zero;
        return none;
    }
};

constexpr InfoRow phase_rows[] = {
    array<Phase>(
        STLTSA_INFO_PHASE, [](const Phase& p) -> const auto& { return p.found->phase; }),
    array<Phase>(
        STLTSA_INFO_PHASE_RESIDUAL,
        [](const Phase& p) -> const auto& { return p.found->residual; }),
    array<Phase>(
        STLTSA_INFO_PHASE_CYCLE, [](const Phase& p) -> const auto& { return p.found->cycle; }),
    list<Phase>(STLTSA_INFO_PHASE_ZERO, [](const Phase& p) { return Zeros{*p.found}; }),
    list<Phase>(
        STLTSA_INFO_OWNER, [](const Phase& p) -> const auto& { return p.found->owners; }),
};

// ---- Signals over cycles ----

using Cycles = stltsa_cycles;

constexpr InfoRow cycles_rows[] = {
    arrays<Cycles>(
        STLTSA_INFO_VALUES, true, [](const Cycles& c) { return c.each.size(); },
        [](const Cycles& c) { return shape_of(c.mean); },
        [](const Cycles& c, std::size_t index) -> const auto& { return c.each[index]; }),
    array<Cycles>(
        STLTSA_INFO_MEAN, [](const Cycles& c) -> const auto& { return c.mean; }),
    array<Cycles>(
        STLTSA_INFO_DEVIATION, [](const Cycles& c) -> const auto& { return c.deviation; }),
    array<Cycles>(
        STLTSA_INFO_SAMPLE_FRAMES, [](const Cycles& c) -> const auto& { return c.rows; }),
    array<Cycles>(
        STLTSA_INFO_WARP, [](const Cycles& c) -> const auto& { return c.warp; }),
    array<Cycles>(
        STLTSA_INFO_DISTANCE, [](const Cycles& c) -> const auto& { return c.total; }),
    array<Cycles>(
        STLTSA_INFO_COLUMN_DISTANCE, [](const Cycles& c) -> const auto& { return c.distance; }),
};

// ---- Events ----

constexpr InfoRow events_rows[] = {
    rows<stltsa_events>(
        STLTSA_INFO_EVENT, [](const stltsa_events& e) -> const auto& { return e.events; }),
    one<stltsa_events>(STLTSA_INFO_LIKENESS, [](const stltsa_events& e) { return e.likeness; }),
};

// ---- Comparisons ----

template <class Get>
constexpr InfoRow of_motions(std::int32_t key, Get) {
    return arrays<stltsa_comparison>(
        key, true, [](const stltsa_comparison&) { return 2; },
        [](const stltsa_comparison& c) { return shape_of(c.motions[0].mean); },
        [](const stltsa_comparison& c, std::size_t which) -> const auto& {
            return Get{}(c.motions[which]);
        });
}

constexpr InfoRow comparison_rows[] = {
    rows<stltsa_comparison>(
        STLTSA_INFO_COMPARISON, [](const stltsa_comparison&) { return 1; },
        [](const stltsa_comparison& c, std::size_t) { return compared_row(c); }),
    rows<stltsa_comparison>(
        STLTSA_INFO_MOTION, [](const stltsa_comparison&) { return 2; }, compared_motion_row),
    rows<stltsa_comparison>(
        STLTSA_INFO_PART, [](const stltsa_comparison& c) { return c.differences.parts.size(); },
        compared_part_row),
    rows<stltsa_comparison>(
        STLTSA_INFO_PART_CHANNEL,
        [](const stltsa_comparison& c) { return c.differences.columns.size(); },
        compared_channel_row),
    of_motions(
        STLTSA_INFO_MEAN, [](const ComparedMotion& m) -> const auto& { return m.mean; }),
    of_motions(
        STLTSA_INFO_DEVIATION, [](const ComparedMotion& m) -> const auto& { return m.deviation; }),
    array<stltsa_comparison>(
        STLTSA_INFO_DIFFERENCE,
        [](const stltsa_comparison& c) -> const auto& { return c.differences.difference; }),
    array<stltsa_comparison>(
        STLTSA_INFO_STANDARD_ERROR,
        [](const stltsa_comparison& c) -> const auto& { return c.differences.error; }),
    array<stltsa_comparison>(
        STLTSA_INFO_MARGIN,
        [](const stltsa_comparison& c) -> const auto& { return c.differences.margin; }),
};

// ---- Streams ----

constexpr InfoRow live_rows[] = {
    list<stltsa_live>(
        STLTSA_INFO_MARK, [](const stltsa_live& l) -> const auto& { return l.names; }),
};

// ---- Denoisings ----

using Denoising = stltsa_denoising;

constexpr InfoRow denoising_rows[] = {
    list<Denoising>(
        STLTSA_INFO_LENGTH, [](const Denoising& d) -> const auto& { return d.lengths; }),
    rows<Denoising>(
        STLTSA_INFO_COLUMN, [](const Denoising& d) { return d.result.columns.size(); },
        [](const Denoising& d, std::size_t index) {
            const motion::DenoisedColumn& c = d.result.columns[index];
            return stltsa_denoised_column{
                c.gamma, c.shift, c.noise, c.noise_share, c.degrees_of_freedom, c.moved};
        }),
    array<Denoising>(
        STLTSA_INFO_CURVE, [](const Denoising& d) -> const auto& { return d.result.curve; }),
    array<Denoising>(
        STLTSA_INFO_CLEANED, [](const Denoising& d) -> const auto& { return d.result.cleaned; }),
    array<Denoising>(
        STLTSA_INFO_MOVES, [](const Denoising& d) -> const auto& { return d.result.moves; }),
    set<Denoising>(
        STLTSA_INFO_GAMMA_OPTION,
        [](const Denoising& d) -> const auto& { return d.options.gamma; }),
    one<Denoising>(STLTSA_INFO_KNOT_ROWS, [](const Denoising& d) { return d.options.knot_step; }),
    one<Denoising>(STLTSA_INFO_ROBUST, [](const Denoising& d) { return d.options.robust; }),
    one<Denoising>(
        STLTSA_INFO_FIT_PERIOD_MIN,
        [](const Denoising& d) { return in_seconds(d.source.period, d.source.samples).shortest; }),
    one<Denoising>(
        STLTSA_INFO_FIT_PERIOD_MAX,
        [](const Denoising& d) { return in_seconds(d.source.period, d.source.samples).longest; }),
    one<Denoising>(STLTSA_INFO_NOTHING_TO_CLEAN,
                   [](const Denoising& d) { return motion::nothing_to_clean(d.result.columns); }),
};

// ---- Syntheses ----

using Synthesis = stltsa_synthesis;

template <class Get>
constexpr InfoRow of_loop(std::int32_t key, Get get) {
    return maybe<Synthesis>(
        key, [](const Synthesis& s) { return s.options.loop ? &s : nullptr; }, get);
}

/// Of a loop that was chosen among the cycles of a clip.
template <class Get>
constexpr InfoRow of_cycles(std::int32_t key, Get get) {
    return maybe<Synthesis>(
        key,
        [](const Synthesis& s) {
            return s.result.loop && s.result.loop->cycles > 0 ? &*s.result.loop : nullptr;
        },
        get);
}

constexpr InfoRow synthesis_rows[] = {
    set<Synthesis>(
        STLTSA_INFO_CROSSFADE,
        [](const Synthesis& s) -> const auto& { return s.options.crossfade; }),
    set<Synthesis>(
        STLTSA_INFO_CUT_RANGE, [](const Synthesis& s) -> const auto& { return s.options.search; }),
    one<Synthesis>(STLTSA_INFO_POSTURE_LIMIT,
                   [](const Synthesis& s) { return s.options.posture_limit; }),
    one<Synthesis>(STLTSA_INFO_UP_AXIS, [](const Synthesis& s) { return s.result.up; }),
    rows<Synthesis>(
        STLTSA_INFO_PIECE, [](const Synthesis& s) { return s.pieces.size(); },
        [](const Synthesis& s, std::size_t index) {
            const PieceFacts& piece = s.pieces[index];
            return stltsa_piece_fact{piece.path.c_str(), piece.begin, piece.end, piece.repeat};
        }),
    rows<Synthesis>(
        STLTSA_INFO_SEAM, [](const Synthesis& s) { return s.result.seams.size(); },
        [](const Synthesis& s, std::size_t index) {
            const synthesis::Seam& seam = s.result.seams[index];
            const double fps = s.clip.clip.fps;
            return stltsa_seam{seam.frame,        static_cast<double>(seam.frame) / fps,
                               seam.piece,        seam.next,
                               seam.cut_end,      seam.cut_begin,
                               seam.crossfade,    static_cast<double>(seam.crossfade) / fps,
                               seam.posture,      seam.step,
                               seam.acceleration, seam.frame == s.clip.clip.frames() ? 1 : 0};
        }),
    one<Synthesis>(STLTSA_INFO_LOOP, [](const Synthesis& s) { return s.options.loop; }),
    of_loop(STLTSA_INFO_IN_PLACE, [](const Synthesis& s) { return s.options.in_place; }),
    {STLTSA_INFO_TRAVEL, true,
     [](const stltsa_info& info) {
         return std::int64_t{handle_of<Synthesis>(info).result.loop ? 3 : 0};
     },
     [](const stltsa_info& info, std::size_t index) {
         return fact(handle_of<Synthesis>(info).result.loop->travel[index]);
     }},
    of_loop(STLTSA_INFO_TURN,
            [](const Synthesis& s) { return s.result.loop->turn * 180 / std::numbers::pi; }),
    of_loop(STLTSA_INFO_COVERAGE, [](const Synthesis& s) { return s.result.loop->coverage; }),
    of_cycles(STLTSA_INFO_LOOP_CYCLES, [](const synthesis::Loop& l) { return l.cycles; }),
    of_cycles(STLTSA_INFO_SOURCE_CYCLES, [](const synthesis::Loop& l) { return l.source_cycles; }),
    list<Synthesis>(
        STLTSA_INFO_NOTE, [](const Synthesis& s) -> const auto& { return s.result.notes; }),
};

} // namespace

std::string no_json(const stltsa_info& info) {
    fail(Status::unsupported, "there is no JSON of {}: read its facts, rows and arrays",
         info.table == &live_table ? "a stream" : "phases, cycles and events");
}

constexpr InfoTable clip_table = {
    STLTSA_HANDLE_CLIP,
    [](const stltsa_info& i) { return clip_json(handle_of<Clip>(i).clip); },
    clip_rows,
    {},
    {},
    {}};
constexpr InfoTable model_table = {
    STLTSA_HANDLE_MODEL, [](const stltsa_info& i) { return model_json(handle_of<Model>(i)); },
    model_rows,          source_rows<Model>,
    fit_rows<Model>,     warning_rows<Model>};
constexpr InfoTable decomposition_table = {
    STLTSA_HANDLE_DECOMPOSITION,
    [](const stltsa_info& i) { return decomposition_json(handle_of<Decomposition>(i)); },
    decomposition_rows,
    source_rows<Decomposition>,
    fit_rows<Decomposition>,
    warning_rows<Decomposition>};
constexpr InfoTable phase_table = {STLTSA_HANDLE_PHASE, no_json, phase_rows, {}, {},
                                   warning_rows<Phase>};
constexpr InfoTable cycles_table = {STLTSA_HANDLE_CYCLES, no_json, cycles_rows, {}, {}, {}};
constexpr InfoTable events_table = {STLTSA_HANDLE_EVENTS,       no_json, events_rows, {}, {},
                                    warning_rows<stltsa_events>};
constexpr InfoTable comparison_table = {
    STLTSA_HANDLE_COMPARISON,
    [](const stltsa_info& i) { return comparison_json(handle_of<stltsa_comparison>(i)); },
    comparison_rows,
    {},
    {},
    warning_rows<stltsa_comparison>};
constexpr InfoTable live_table = {STLTSA_HANDLE_LIVE, no_json, live_rows, {}, {}, {}};
constexpr InfoTable denoising_table = {
    STLTSA_HANDLE_DENOISING,
    [](const stltsa_info& i) { return denoising_json(handle_of<Denoising>(i)); },
    denoising_rows,
    source_rows<Denoising>,
    fit_rows<Denoising>,
    warning_rows<Denoising>};
constexpr InfoTable synthesis_table = {STLTSA_HANDLE_SYNTHESIS,
                                       [](const stltsa_info& i) {
                                           const auto& made = handle_of<Synthesis>(i);
                                           return synthesis_json(made.clip.clip, made);
                                       },
                                       synthesis_rows,
                                       {},
                                       {},
                                       warning_rows<Synthesis>};

std::span<const InfoTable* const> info_tables() {
    static constexpr const InfoTable* all[] = {
        &clip_table,   &model_table,      &decomposition_table, &phase_table,     &cycles_table,
        &events_table, &comparison_table, &live_table,          &denoising_table, &synthesis_table};
    return all;
}

} // namespace stltsa::capi

const stltsa_info* stltsa_clip_info(const stltsa_clip* clip) noexcept {
    return clip;
}

const stltsa_info* stltsa_model_info(const stltsa_model* model) noexcept {
    return model;
}

const stltsa_info* stltsa_phase_info(const stltsa_phase* phase) noexcept {
    return phase;
}

const stltsa_info* stltsa_cycles_info(const stltsa_cycles* cycles) noexcept {
    return cycles;
}

const stltsa_info* stltsa_events_info(const stltsa_events* events) noexcept {
    return events;
}

const stltsa_info* stltsa_comparison_info(const stltsa_comparison* comparison) noexcept {
    return comparison;
}

const stltsa_info* stltsa_live_info(const stltsa_live* live) noexcept {
    return live;
}

const stltsa_info* stltsa_decomposition_info(const stltsa_decomposition* decomposition) noexcept {
    return decomposition;
}

const stltsa_info* stltsa_denoising_info(const stltsa_denoising* denoising) noexcept {
    return denoising;
}

const stltsa_info* stltsa_synthesis_info(const stltsa_synthesis* synthesis) noexcept {
    return synthesis;
}
