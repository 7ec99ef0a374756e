// SPDX-License-Identifier: BSD-3-Clause
#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

void copy_interval(const std::vector<stltsa_interval>& from, int64_t index, const char* what,
                   stltsa_interval& to) {
    if (index < 0 || index >= static_cast<int64_t>(from.size()))
        fail(Status::argument, "{} {} does not exist: there are {}", what, index, from.size());
    to = from[static_cast<std::size_t>(index)];
}

std::int64_t integer_of(const stltsa_decomposition& d, int32_t key) {
    switch (key) {
    case STLTSA_DECOMPOSITION_SAMPLES:
        return d.source.samples.count;
    case STLTSA_DECOMPOSITION_FIRST_FRAME:
        return d.source.samples.first;
    case STLTSA_DECOMPOSITION_FRAME_STEP:
        return d.source.samples.step;
    case STLTSA_DECOMPOSITION_NEIGHBORS:
        return d.result.parameters.neighbors;
    case STLTSA_DECOMPOSITION_WINDOW:
        return d.result.parameters.window;
    case STLTSA_DECOMPOSITION_DIMENSION:
        return d.result.parameters.dimension;
    case STLTSA_DECOMPOSITION_COORDINATE:
        return d.result.coordinate;
    case STLTSA_DECOMPOSITION_REPRESENTATIVE:
        return d.result.representative;
    case STLTSA_DECOMPOSITION_BEST:
        return d.result.best;
    case STLTSA_DECOMPOSITION_FEATURES:
        return static_cast<std::int64_t>(d.source.samples.features);
    default:
        fail(Status::argument, "{} is no integer key of a decomposition", key);
    }
}

double real_of(const stltsa_decomposition& d, int32_t key) {
    switch (key) {
    case STLTSA_DECOMPOSITION_PERIOD:
        return d.source.period.period;
    case STLTSA_DECOMPOSITION_CYCLICITY:
        return d.result.cyclicity;
    case STLTSA_DECOMPOSITION_LAG_QUALITY:
        return d.result.lag_quality;
    case STLTSA_DECOMPOSITION_FPS:
        return d.source.samples.fps;
    default:
        fail(Status::argument, "{} is no real key of a decomposition", key);
    }
}

} // namespace

const char* stltsa_unit_name(int32_t kind) noexcept {
    switch (kind) {
    case STLTSA_UNIT_PREPARING:
        return "preparing";
    case STLTSA_UNIT_INITIAL:
        return "initial";
    case STLTSA_UNIT_CYCLIC:
        return "cyclic";
    case STLTSA_UNIT_FINAL:
        return "final";
    case STLTSA_UNIT_WIND_UP:
        return "wind-up";
    case STLTSA_UNIT_ACTION:
        return "action";
    case STLTSA_UNIT_CYCLE:
        return "cycle";
    default:
        return "unknown";
    }
}

stltsa_status stltsa_decompose(const stltsa_clip* clip, const stltsa_options* options,
                               stltsa_decomposition** decomposition) noexcept {
    return guard([&] {
        required(decomposition, "decomposition") = nullptr;
        const clip::Clip& from = required(clip, "clip").clip;
        if (!(from.fps > 0))
            fail(Status::argument, "the clip's frame rate is unknown: open it with option fps");
        const capi::OptionsReader reader(options);
        *decomposition = new stltsa_decomposition(results::decompose(
            from, reader.prepare_options(), reader.decompose_options(), reader.progress()));
    });
}

void stltsa_decomposition_free(stltsa_decomposition* decomposition) noexcept {
    delete decomposition;
}

int64_t stltsa_decomposition_unit_count(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? 0 : static_cast<int64_t>(decomposition->units.size());
}

stltsa_status stltsa_decomposition_unit(const stltsa_decomposition* decomposition, int64_t index,
                                        stltsa_interval* unit) noexcept {
    return guard([&] {
        copy_interval(required(decomposition, "decomposition").units, index, "unit",
                      required(unit, "unit"));
    });
}

int64_t stltsa_decomposition_cycle_count(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? 0 : static_cast<int64_t>(decomposition->cycles.size());
}

stltsa_status stltsa_decomposition_cycle(const stltsa_decomposition* decomposition, int64_t index,
                                         stltsa_interval* cycle) noexcept {
    return guard([&] {
        copy_interval(required(decomposition, "decomposition").cycles, index, "cycle",
                      required(cycle, "cycle"));
    });
}

stltsa_status stltsa_decomposition_get_int(const stltsa_decomposition* decomposition, int32_t key,
                                           int64_t* value) noexcept {
    return guard([&] {
        required(value, "value") = integer_of(required(decomposition, "decomposition"), key);
    });
}

stltsa_status stltsa_decomposition_get_real(const stltsa_decomposition* decomposition, int32_t key,
                                            double* value) noexcept {
    return guard(
        [&] { required(value, "value") = real_of(required(decomposition, "decomposition"), key); });
}

stltsa_status stltsa_decomposition_curve(const stltsa_decomposition* decomposition,
                                         const stltsa_out* curve) noexcept {
    return guard([&] {
        capi::write_column(curve, "curve", required(decomposition, "decomposition").result.curve);
    });
}

stltsa_status stltsa_decomposition_coords(const stltsa_decomposition* decomposition,
                                          const stltsa_out* coords) noexcept {
    return guard([&] {
        capi::write_output(coords, "coords",
                           required(decomposition, "decomposition").result.coords.view());
    });
}

stltsa_status stltsa_decomposition_loop(const stltsa_decomposition* decomposition,
                                        const stltsa_out* loop) noexcept {
    return guard([&] {
        capi::write_output(loop, "loop",
                           required(decomposition, "decomposition").result.loop.view());
    });
}

const char* stltsa_decomposition_reason(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? "" : decomposition->result.reason.c_str();
}

int64_t stltsa_decomposition_warning_count(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? 0
                                    : static_cast<int64_t>(decomposition->result.warnings.size());
}

const char* stltsa_decomposition_warning(const stltsa_decomposition* decomposition,
                                         int64_t index) noexcept {
    if (index < 0 || index >= stltsa_decomposition_warning_count(decomposition))
        return "";
    return decomposition->result.warnings[static_cast<std::size_t>(index)].text.c_str();
}

stltsa_status stltsa_decomposition_json(const stltsa_decomposition* decomposition,
                                        char** json) noexcept {
    return guard([&] {
        required(json, "json") = nullptr;
        *json =
            capi::caller_string(capi::decomposition_json(required(decomposition, "decomposition")));
    });
}
