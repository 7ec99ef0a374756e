// SPDX-License-Identifier: BSD-3-Clause
// The facts of each kind of handle.
#include <algorithm>
#include <numbers>

#include "capi/handles.hpp"

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
const ltsa::Parameters* fit_of(const stltsa_dimension& result) {
    return &result.dimension.parameters;
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
const Warnings& warnings_of(const stltsa_decomposition& decomposition) {
    return decomposition.warnings;
}
const Warnings& warnings_of(const stltsa_denoising& denoising) {
    return denoising.warnings;
}
template <class Handle>
const Warnings& warnings_of(const Handle& handle) {
    return handle.result.warnings;
}

template <class H, class Get>
constexpr InfoRow of_warning(std::int32_t key, Get get) {
    return each<H>(
        key, [](const H& h) -> const auto& { return warnings_of(h); }, get);
}

template <class H>
constexpr InfoRow warning_rows[] = {
    of_warning<H>(
        STLTSA_INFO_WARNING, [](const Warning& w) -> const auto& { return w.text; }),
    of_warning<H>(STLTSA_INFO_WARNING_CODE, [](const Warning& w) { return w.code; }),
    of_warning<H>(STLTSA_INFO_WARNING_BEGIN, [](const Warning& w) { return w.begin_s; }),
    of_warning<H>(STLTSA_INFO_WARNING_END, [](const Warning& w) { return w.end_s; }),
};

// ---- Clips ----

using Clip = stltsa_clip;

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
        STLTSA_INFO_UNIT, [](const Clip& c) -> const auto& { return c.clip.unit; }),
    one<Clip>(STLTSA_INFO_FILE_UP_AXIS, [](const Clip& c) { return c.clip.up; }),
};

// ---- Models ----

using Model = stltsa_model;

template <class Get>
constexpr InfoRow of_component(std::int32_t key, Get get) {
    return each<Model>(
        key, [](const Model& m) -> const auto& { return m.model.components; }, get);
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
    of_component(STLTSA_INFO_COMPONENT_ROWS, [](const ltsa::Component& c) { return c.frames; }),
    of_component(STLTSA_INFO_RANK_DEFICIENT,
                 [](const ltsa::Component& c) { return c.rank_deficient_windows; }),
    of_component(STLTSA_INFO_SOLVES, [](const ltsa::Component& c) { return c.solves; }),
    of_component(STLTSA_INFO_RESIDUAL, [](const ltsa::Component& c) { return c.residual; }),
    of_component(STLTSA_INFO_ERROR_ESTIMATE,
                 [](const ltsa::Component& c) { return c.error_estimate; }),
    of_component(STLTSA_INFO_GAP, [](const ltsa::Component& c) { return c.gap; }),
    one<Model>(STLTSA_INFO_COMPONENTS, [](const Model& m) { return m.model.components.size(); }),
};

// ---- Intrinsic dimension ----

using Dimension = stltsa_dimension;

constexpr InfoRow dimension_rows[] = {
    one<Dimension>(STLTSA_INFO_LOCAL_PCA, [](const Dimension& d) { return d.dimension.local_pca; }),
    one<Dimension>(STLTSA_INFO_EIGENGAP, [](const Dimension& d) { return d.dimension.eigengap; }),
    one<Dimension>(
        STLTSA_INFO_LOCAL_PCA_REASON,
        [](const Dimension& d) -> const auto& { return d.dimension.local_pca_reason; }),
    one<Dimension>(
        STLTSA_INFO_EIGENGAP_REASON,
        [](const Dimension& d) -> const auto& { return d.dimension.eigengap_reason; }),
    one<Dimension>(STLTSA_INFO_VARIANCE,
                   [](const Dimension& d) { return d.dimension.local_variance; }),
    one<Dimension>(STLTSA_INFO_EIGENGAP_THRESHOLD,
                   [](const Dimension& d) { return d.dimension.threshold; }),
    list<Dimension>(
        STLTSA_INFO_EIGENVALUE,
        [](const Dimension& d) -> const auto& { return d.dimension.eigenvalues; }),
    list<Dimension>(
        STLTSA_INFO_LOCAL_VARIANCE,
        [](const Dimension& d) -> const auto& { return d.dimension.local_variances; }),
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
};

// ---- Denoisings ----

using Denoising = stltsa_denoising;

template <class Get>
constexpr InfoRow of_column(std::int32_t key, Get get) {
    return each<Denoising>(
        key, [](const Denoising& d) -> const auto& { return d.result.columns; }, get);
}

constexpr InfoRow denoising_rows[] = {
    list<Denoising>(
        STLTSA_INFO_LENGTH, [](const Denoising& d) -> const auto& { return d.lengths; }),
    of_column(STLTSA_INFO_GAMMA, [](const motion::DenoisedColumn& c) { return c.gamma; }),
    of_column(STLTSA_INFO_SHIFT, [](const motion::DenoisedColumn& c) { return c.shift; }),
    of_column(STLTSA_INFO_NOISE, [](const motion::DenoisedColumn& c) { return c.noise; }),
    of_column(STLTSA_INFO_DEGREES_OF_FREEDOM,
              [](const motion::DenoisedColumn& c) { return c.degrees_of_freedom; }),
    of_column(STLTSA_INFO_MOVED, [](const motion::DenoisedColumn& c) { return c.moved; }),
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
    one<Denoising>(STLTSA_INFO_COLUMNS, [](const Denoising& d) { return d.result.columns.size(); }),
    of_column(STLTSA_INFO_NOISE_SHARE,
              [](const motion::DenoisedColumn& c) { return c.noise_share; }),
    one<Denoising>(STLTSA_INFO_NOTHING_TO_CLEAN,
                   [](const Denoising& d) { return motion::nothing_to_clean(d.result.columns); }),
};

// ---- Syntheses ----

using Synthesis = stltsa_synthesis;

template <class Get>
constexpr InfoRow of_piece(std::int32_t key, Get get) {
    return each<Synthesis>(
        key, [](const Synthesis& s) -> const auto& { return s.pieces; }, get);
}

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
    of_piece(
        STLTSA_INFO_PIECE_PATH, [](const PieceFacts& p) -> const auto& { return p.path; }),
    of_piece(STLTSA_INFO_PIECE_BEGIN, [](const PieceFacts& p) { return p.begin; }),
    of_piece(STLTSA_INFO_PIECE_END, [](const PieceFacts& p) { return p.end; }),
    of_piece(STLTSA_INFO_PIECE_REPEAT, [](const PieceFacts& p) { return p.repeat; }),
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

constexpr InfoTable clip_table = {STLTSA_HANDLE_CLIP, clip_rows, {}, {}, {}};
constexpr InfoTable model_table = {STLTSA_HANDLE_MODEL, model_rows, source_rows<Model>,
                                   fit_rows<Model>, warning_rows<Model>};
constexpr InfoTable dimension_table = {
    STLTSA_HANDLE_DIMENSION, dimension_rows, source_rows<Dimension>, fit_rows<Dimension>, {}};
constexpr InfoTable decomposition_table = {STLTSA_HANDLE_DECOMPOSITION, decomposition_rows,
                                           source_rows<Decomposition>, fit_rows<Decomposition>,
                                           warning_rows<Decomposition>};
constexpr InfoTable denoising_table = {STLTSA_HANDLE_DENOISING, denoising_rows,
                                       source_rows<Denoising>, fit_rows<Denoising>,
                                       warning_rows<Denoising>};
constexpr InfoTable synthesis_table = {
    STLTSA_HANDLE_SYNTHESIS, synthesis_rows, {}, {}, warning_rows<Synthesis>};

} // namespace stltsa::capi

const stltsa_info* stltsa_clip_info(const stltsa_clip* clip) noexcept {
    return clip;
}

const stltsa_info* stltsa_model_info(const stltsa_model* model) noexcept {
    return model;
}

const stltsa_info* stltsa_dimension_info(const stltsa_dimension* dimension) noexcept {
    return dimension;
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
