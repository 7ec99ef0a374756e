// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>

#include "capi/boundary/guard.hpp"
#include "capi/boundary/structs.hpp"
#include "capi/handles.hpp"
#include "results/keep_cycle.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

namespace {

std::vector<double> phases_of(const std::vector<results::PhasedMark>& marks) {
    std::vector<double> phases;
    for (const results::PhasedMark& mark : marks)
        phases.push_back(mark.phase);
    return phases;
}

std::vector<std::string> names_of(const std::vector<results::PhasedMark>& marks) {
    std::vector<std::string> names;
    for (const results::PhasedMark& mark : marks)
        names.push_back(mark.name);
    return names;
}

/// Copies one row of any stride and type without allocating.
void read_row(const stltsa_in& in, std::vector<double>& row) {
    const auto cols = static_cast<int64_t>(row.size());
    if (in.rows != 1 || in.cols != cols)
        fail(Status::shape, "features is {} x {}; it must be 1 x {}", in.rows, in.cols, cols);
    const bool single = in.dtype == STLTSA_F32;
    if (!single && in.dtype != STLTSA_F64)
        fail(Status::argument, "features holds type {}; it must be STLTSA_F64 or STLTSA_F32",
             in.dtype);
    const auto* from =
        static_cast<const char*>(&required(static_cast<const char*>(in.data), "features->data"));
    const bool packed = in.row_stride == 0 && in.col_stride == 0;
    const int64_t width = single ? sizeof(float) : sizeof(double);
    const int64_t stride = packed ? width : in.col_stride;
    for (int64_t c = 0; c < cols; ++c) {
        float narrow = 0;
        double wide = 0;
        if (single)
            std::memcpy(&narrow, from + c * stride, sizeof narrow);
        else
            std::memcpy(&wide, from + c * stride, sizeof wide);
        row[static_cast<std::size_t>(c)] = single ? static_cast<double>(narrow) : wide;
    }
}

int32_t kind_of(const phase::LiveFrame& frame) {
    if (frame.still)
        return STLTSA_SEGMENT_REST;
    return frame.known ? STLTSA_SEGMENT_CYCLIC : STLTSA_SEGMENT_ACTION;
}

} // namespace

stltsa_status stltsa_model_keep_cycle(stltsa_model* model, const stltsa_phase* phase) noexcept {
    return compute(
        [&] { results::keep_cycle(required(model, "model"), required(phase, "phase")); });
}

stltsa_status stltsa_model_keep_mark(stltsa_model* model, const stltsa_phase* phase, double frame,
                                     const char* name) noexcept {
    return guard([&] {
        results::keep_mark(required(model, "model"), required(phase, "phase"), frame,
                           &required(name, "name"));
    });
}

int32_t stltsa_model_has_cycle(const stltsa_model* model) noexcept {
    return model != nullptr && model->live.has_cycle ? 1 : 0;
}

stltsa_status stltsa_live_new(const stltsa_model* model, stltsa_live** live) noexcept {
    return guard([&] {
        required(live, "live") = nullptr;
        const results::Live& kept = required(model, "model").live;
        if (!kept.has_cycle)
            fail(Status::unsupported, "the model keeps no mean cycle: keep it with "
                                      "stltsa_model_keep_cycle (stltsa fit -o does so if the clip "
                                      "has cycles)");
        *live =
            new stltsa_live{names_of(kept.marks), std::vector<double>(kept.cycle.weights.size()),
                            phase::LivePhase(kept.cycle, phases_of(kept.marks))};
    });
}

void stltsa_live_free(stltsa_live* live) noexcept {
    delete live;
}

int64_t stltsa_live_mark_count(const stltsa_live* live) noexcept {
    return live == nullptr ? 0 : static_cast<int64_t>(live->names.size());
}

const char* stltsa_live_mark_name(const stltsa_live* live, int64_t index) noexcept {
    if (index < 0 || index >= stltsa_live_mark_count(live))
        return "";
    return live->names[static_cast<std::size_t>(index)].c_str();
}

stltsa_status stltsa_live_push(stltsa_live* live, double seconds, const stltsa_in* features,
                               stltsa_live_frame* frame) noexcept {
    return guard([&] {
        stltsa_live& stream = required(live, "live");
        if (!std::isfinite(seconds))
            fail(Status::argument, "seconds is {}", seconds);
        read_row(required(features, "features"), stream.row);
        capi::check_size(required(frame, "frame").size, "frame", "stltsa_live_frame");
        const bool whole =
            std::ranges::all_of(stream.row, [](double v) { return std::isfinite(v); });
        const phase::LiveFrame found =
            whole ? stream.phase.push(seconds, stream.row.data()) : stream.phase.go_on(seconds);
        const stltsa_live_frame copy = {
            sizeof(stltsa_live_frame), found.passed,        found.phase,
            found.turns_per_second,    found.turns,         found.distance,
            found.confidence,          found.known ? 1 : 0, kind_of(found)};
        capi::give(copy, frame, "frame", "stltsa_live_frame");
    });
}
