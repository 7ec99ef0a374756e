// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/progress.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/boundary/structs.hpp"
#include "capi/handles.hpp"
#include "capi/options/reader.hpp"
#include "clip/arrays/arrays.hpp"
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

/// Copies numbers of any stride and type without allocating.
void read(const stltsa_in& in, const char* name, int64_t rows, int64_t cols, double* to) {
    if (in.rows != rows || in.cols != cols)
        fail(Status::shape, "{} is {} x {}; it must be {} x {}", name, in.rows, in.cols, rows,
             cols);
    const bool single = in.dtype == STLTSA_F32;
    if (!single && in.dtype != STLTSA_F64)
        fail(Status::argument, "{} holds type {}; it must be STLTSA_F64 or STLTSA_F32", name,
             in.dtype);
    if (in.data == nullptr)
        fail(Status::argument, "{}->data is NULL", name);
    const auto* from = static_cast<const char*>(in.data);
    const bool packed = in.row_stride == 0 && in.col_stride == 0;
    const int64_t width = single ? sizeof(float) : sizeof(double);
    const int64_t along = packed ? width : in.col_stride;
    const int64_t down = packed ? width * cols : in.row_stride;
    for (int64_t r = 0; r < rows; ++r)
        for (int64_t c = 0; c < cols; ++c) {
            float narrow = 0;
            double wide = 0;
            if (single)
                std::memcpy(&narrow, from + r * down + c * along, sizeof narrow);
            else
                std::memcpy(&wide, from + r * down + c * along, sizeof wide);
            *to++ = single ? static_cast<double>(narrow) : wide;
        }
}

bool all_finite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

int32_t kind_of(const phase::LiveFrame& frame) {
    if (frame.still)
        return STLTSA_SEGMENT_REST;
    return frame.known ? STLTSA_SEGMENT_CYCLIC : STLTSA_SEGMENT_ACTION;
}

void check_call(double seconds, const stltsa_live_frame* frame) {
    constexpr double most = 1e12; // beyond it frames would share their times
    if (!(std::abs(seconds) <= most))
        fail(Status::argument,
             "seconds is {}; it must be between -1e12 and 1e12: count from the first frame",
             seconds);
    capi::check_size(required(frame, "frame").size, "frame", "stltsa_live_frame");
}

/// The answer for the features in stream.row; `whole`: enough of the frame is there.
void answer(stltsa_live& stream, double seconds, bool whole, stltsa_live_frame* frame) {
    const phase::LiveFrame found =
        whole ? stream.phase.push(seconds, stream.row.data()) : stream.phase.go_on(seconds);
    const stltsa_live_frame copy = {sizeof(stltsa_live_frame), found.passed,        found.phase,
                                    found.turns_per_second,    found.turns,         found.distance,
                                    found.confidence,          found.known ? 1 : 0, kind_of(found)};
    capi::give(copy, frame, "frame", "stltsa_live_frame");
}

/// Sets what is seen with no confidence to NaN.
void drop_unsure(stltsa_live& stream, const stltsa_in& confidence, int64_t points) {
    read(confidence, "confidence", points, 1, stream.unsure.data());
    const auto space = static_cast<std::size_t>(stream.features.space());
    for (std::size_t p = 0; p < static_cast<std::size_t>(points); ++p)
        if (!(stream.unsure[p] > 0))
            std::fill_n(stream.values.begin() + static_cast<std::ptrdiff_t>(space * p), space,
                        std::numeric_limits<double>::quiet_NaN());
}

/// Quaternions or matrices. False if a number is not finite.
bool read_pose(stltsa_live& stream, clip::RotationForm form, const stltsa_in& rotations,
               const stltsa_in* root) {
    const clip::Skeleton& skeleton = stream.features.skeleton();
    const auto joints = std::ssize(skeleton.joints);
    const bool matrices = form == clip::RotationForm::matrices;
    if (!matrices && form != clip::RotationForm::quaternions)
        fail(Status::argument, "form is {}; expected STLTSA_ROTATIONS_*", static_cast<int>(form));
    if (stream.features.of_channels())
        fail(Status::unsupported, "the features of the model are numbers of its file: push them as "
                                  "STLTSA_ROTATIONS_CHANNELS, or fit with the features positions");
    read(rotations, "rotations", joints, matrices ? 9 : 4, stream.values.data());
    clip::Vec3 place = skeleton.joints.front().offset;
    if (root != nullptr)
        read(*root, "root", 1, 3, place.data());
    const auto* end = stream.values.data() + joints * (matrices ? 9 : 4);
    if (!std::all_of<const double*>(stream.values.data(), end,
                                    [](double v) { return std::isfinite(v); }))
        return false;
    const std::size_t wrong =
        clip::read_rotations(skeleton, form, stream.values.data(), stream.local);
    if (wrong < stream.local.size())
        fail(Status::argument, "{}", clip::no_rotation(skeleton, form, wrong));
    return stream.features.next(stream.local, place, stream.row.data());
}

} // namespace

stltsa_status stltsa_model_keep_cycle(stltsa_model* model, const stltsa_phase* phase,
                                      const stltsa_options* options) noexcept {
    return compute(options, [&] {
        report_progress(Stage::units, 0);
        results::keep_cycle(required(model, "model"), required(phase, "phase"));
    });
}

stltsa_status stltsa_model_keep_mark(stltsa_model* model, const stltsa_phase* phase, double frame,
                                     const char* name) noexcept {
    return guard([&] {
        results::keep_mark(required(model, "model"), required(phase, "phase"), frame,
                           &required(name, "name"));
    });
}

stltsa_status stltsa_live_new(const stltsa_model* model, stltsa_live** live) noexcept {
    return guard([&] {
        required(live, "live") = nullptr;
        const results::Live& kept = required(model, "model").live;
        if (!kept.has_cycle)
            fail(Status::unsupported, "the model keeps no mean cycle: keep it with "
                                      "stltsa_model_keep_cycle (stltsa fit -o does so if the clip "
                                      "has cycles)");
        *live = new stltsa_live(names_of(kept.marks), clip::FrameFeatures(kept.body),
                                phase::LivePhase(kept.cycle, phases_of(kept.marks)));
    });
}

void stltsa_live_free(stltsa_live* live) noexcept {
    delete live;
}

stltsa_status stltsa_live_push(stltsa_live* live, double seconds, const stltsa_in* features,
                               stltsa_live_frame* frame) noexcept {
    return guard([&] {
        stltsa_live& stream = required(live, "live");
        check_call(seconds, frame);
        const auto count = static_cast<int64_t>(stream.row.size());
        const bool made = stream.features.has_skeleton();
        std::vector<double>& to = made ? stream.row : stream.values;
        read(required(features, "features"), "features", 1, count, to.data());
        answer(stream, seconds,
               made ? all_finite(to) : stream.features.next(to.data(), stream.row.data()), frame);
    });
}

stltsa_status stltsa_live_push_points(stltsa_live* live, double seconds, const stltsa_in* points,
                                      const stltsa_in* confidence,
                                      stltsa_live_frame* frame) noexcept {
    return guard([&] {
        stltsa_live& stream = required(live, "live");
        check_call(seconds, frame);
        if (stream.features.space() == 0)
            fail(Status::unsupported, "the model is of a clip without points: push {}",
                 stream.features.has_skeleton() ? "poses" : "features");
        const int64_t space = stream.features.space(), count = stream.features.values() / space;
        read(required(points, "points"), "points", count, space, stream.values.data());
        if (confidence != nullptr)
            drop_unsure(stream, *confidence, count);
        answer(stream, seconds, stream.features.next(stream.values.data(), stream.row.data()),
               frame);
    });
}

stltsa_status stltsa_live_push_pose(stltsa_live* live, double seconds, int32_t form,
                                    const stltsa_in* rotations, const stltsa_in* root,
                                    stltsa_live_frame* frame) noexcept {
    return guard([&] {
        stltsa_live& stream = required(live, "live");
        check_call(seconds, frame);
        if (!stream.features.has_skeleton())
            fail(Status::unsupported, "the model is of a clip without a skeleton: push points or "
                                      "features");
        if (form != STLTSA_ROTATIONS_CHANNELS) {
            answer(stream, seconds,
                   read_pose(stream, static_cast<clip::RotationForm>(form),
                             required(rotations, "rotations"), root),
                   frame);
            return;
        }
        if (root != nullptr)
            fail(Status::argument, "the channels say where the root is: pass NULL for root");
        read(required(rotations, "rotations"), "rotations", 1, stream.features.values(),
             stream.values.data());
        answer(stream, seconds, stream.features.next(stream.values.data(), stream.row.data()),
               frame);
    });
}

stltsa_status stltsa_live_push_frame(stltsa_live* live, double seconds, const stltsa_clip* clip,
                                     int64_t index, stltsa_live_frame* frame) noexcept {
    return guard([&] {
        stltsa_live& stream = required(live, "live");
        check_call(seconds, frame);
        const clip::Clip& from = required(clip, "clip").clip;
        if (index < 0 || index >= from.frames())
            fail(Status::argument, "frame {} does not exist: the clip has frames 0 to {}", index,
                 from.frames() - 1);
        answer(stream, seconds, stream.features.next(from, index, stream.row.data()), frame);
    });
}
