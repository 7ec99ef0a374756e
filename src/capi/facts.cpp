// SPDX-License-Identifier: BSD-3-Clause
// The facts of clips, phases, cycles, events, comparisons and streams, and the list of all tables.
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

// ---- Warnings ----

const Warnings& warnings_of(const stltsa_phase& phase) {
    return phase.found->warnings;
}
template <class Handle>
const Warnings& warnings_of(const Handle& handle) {
    return handle.warnings;
}

template <class H>
constexpr InfoRow warning_rows[] = {
    warning_row<H>([](const H& h) -> const auto& { return warnings_of(h); })};

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
