// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

struct UnitKind {
    int32_t value;
    const char* name;
};
constexpr UnitKind unit_kinds[] = {
    {static_cast<int32_t>(motion::UnitKind::preparing), "preparing"},
    {static_cast<int32_t>(motion::UnitKind::initial), "initial"},
    {static_cast<int32_t>(motion::UnitKind::cyclic), "cyclic"},
    {static_cast<int32_t>(motion::UnitKind::final), "final"},
    {static_cast<int32_t>(motion::UnitKind::wind_up), "wind-up"},
    {static_cast<int32_t>(motion::UnitKind::action), "action"},
    {STLTSA_UNIT_CYCLE, "cycle"},
};
// The values of motion::UnitKind are those of the header.
static_assert(unit_kinds[0].value == STLTSA_UNIT_PREPARING &&
              unit_kinds[1].value == STLTSA_UNIT_INITIAL &&
              unit_kinds[2].value == STLTSA_UNIT_CYCLIC &&
              unit_kinds[3].value == STLTSA_UNIT_FINAL &&
              unit_kinds[4].value == STLTSA_UNIT_WIND_UP &&
              unit_kinds[5].value == STLTSA_UNIT_ACTION);

void copy_interval(const std::vector<stltsa_interval>& from, int64_t index, const char* what,
                   stltsa_interval& to) {
    if (index < 0 || index >= static_cast<int64_t>(from.size()))
        fail(Status::argument, "{} {} does not exist: there are {}", what, index, from.size());
    to = from[static_cast<std::size_t>(index)];
}

} // namespace

const char* stltsa_unit_name(int32_t kind) noexcept {
    const auto* const row = std::ranges::find(unit_kinds, kind, &UnitKind::value);
    return row == std::end(unit_kinds) ? "unknown" : row->name;
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
