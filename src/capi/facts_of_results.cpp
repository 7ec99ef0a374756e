// SPDX-License-Identifier: BSD-3-Clause
// The facts of results that have working samples: models, decompositions, denoisings; and of
// syntheses.
#include <algorithm>
#include <array>
#include <numbers>

#include "base/numbers.hpp"
#include "capi/compared_rows.hpp"
#include "capi/handles.hpp"
#include "capi/info/warnings.hpp"
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

template <class H, class Get>
constexpr InfoRow of_recurrent(std::int32_t key, Get get) {
    return maybe<H>(
        key,
        [](const H& h) {
            const ltsa::Parameters* fit = fit_of(h);
            return fit != nullptr && fit->mode == ltsa::Mode::recurrent ? fit : nullptr;
        },
        get);
}

template <class H>
constexpr InfoRow fit_rows[] = {
    of_fit<H>(STLTSA_INFO_MODE, [](const ltsa::Parameters& p) { return p.mode; }),
    of_fit<H>(STLTSA_INFO_NEIGHBORS, [](const ltsa::Parameters& p) { return p.neighbors; }),
    of_fit<H>(STLTSA_INFO_WINDOW, [](const ltsa::Parameters& p) { return p.window; }),
    of_fit<H>(STLTSA_INFO_DIMENSION, [](const ltsa::Parameters& p) { return p.dimension; }),
    of_fit<H>(STLTSA_INFO_INCLUDE_SELF, [](const ltsa::Parameters& p) { return p.include_self; }),
    of_recurrent<H>(STLTSA_INFO_LINKS, [](const ltsa::Parameters& p) { return p.links; }),
    of_recurrent<H>(STLTSA_INFO_EXCLUSION, [](const ltsa::Parameters& p) { return p.exclusion; }),
};

// ---- Warnings ----

const Warnings& warnings_of(const stltsa_model& model) {
    return model.model.warnings;
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
    warning_row<H>([](const H& h) -> const auto& { return warnings_of(h); })};

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

} // namespace stltsa::capi
