// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <span>
#include <type_traits>

#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

namespace {

struct KindName {
    int32_t value;
    const char* name;
};
constexpr KindName unit_kinds[] = {
    {static_cast<int32_t>(motion::UnitKind::preparing), "preparing"},
    {static_cast<int32_t>(motion::UnitKind::initial), "initial"},
    {static_cast<int32_t>(motion::UnitKind::cyclic), "cyclic"},
    {static_cast<int32_t>(motion::UnitKind::final), "final"},
    {static_cast<int32_t>(motion::UnitKind::wind_up), "wind-up"},
    {static_cast<int32_t>(motion::UnitKind::action), "action"},
    {STLTSA_UNIT_CYCLE, "cycle"},
    {static_cast<int32_t>(motion::UnitKind::hold), "hold"},
};
// The values of motion::UnitKind are those of the header.
static_assert(unit_kinds[0].value == STLTSA_UNIT_PREPARING &&
              unit_kinds[1].value == STLTSA_UNIT_INITIAL &&
              unit_kinds[2].value == STLTSA_UNIT_CYCLIC &&
              unit_kinds[3].value == STLTSA_UNIT_FINAL &&
              unit_kinds[4].value == STLTSA_UNIT_WIND_UP &&
              unit_kinds[5].value == STLTSA_UNIT_ACTION && unit_kinds[7].value == STLTSA_UNIT_HOLD);
constexpr KindName segment_kinds[] = {
    {static_cast<int32_t>(motion::SegmentKind::cyclic), "cyclic"},
    {static_cast<int32_t>(motion::SegmentKind::repetitions), "repetitions"},
    {static_cast<int32_t>(motion::SegmentKind::action), "action"},
    {static_cast<int32_t>(motion::SegmentKind::rest), "rest"},
};
static_assert(segment_kinds[0].value == STLTSA_SEGMENT_CYCLIC &&
              segment_kinds[1].value == STLTSA_SEGMENT_REPETITIONS &&
              segment_kinds[2].value == STLTSA_SEGMENT_ACTION &&
              segment_kinds[3].value == STLTSA_SEGMENT_REST);

template <class T>
void copy_one(std::span<const std::type_identity_t<T>> from, int64_t index, const char* what,
              T& to) {
    if (index < 0 || index >= static_cast<int64_t>(from.size()))
        fail(Status::argument, "{} {} does not exist: there are {}", what, index, from.size());
    to = from[static_cast<std::size_t>(index)];
}

template <std::size_t Count>
const char* name_in(const KindName (&kinds)[Count], int32_t kind) {
    const auto* const row = std::ranges::find(kinds, kind, &KindName::value);
    return row == std::end(kinds) ? "unknown" : row->name;
}

results::Parts parts_of(const stltsa_decomposition* decomposition, int32_t kind) {
    if (kind < STLTSA_PART_CYCLE || kind > STLTSA_PART_REPETITION)
        fail(Status::argument, "kind is {}; it must be STLTSA_PART_CYCLE, _STEP or _REPETITION",
             kind);
    return required(decomposition, "decomposition").parts(kind);
}

/// The element of a list of lists; null if an index is out of range.
template <class T>
const T* element(const std::vector<T>& list, int64_t index) {
    return index >= 0 && index < static_cast<int64_t>(list.size())
               ? &list[static_cast<std::size_t>(index)]
               : nullptr;
}

} // namespace

const char* stltsa_unit_name(int32_t kind) noexcept {
    return name_in(unit_kinds, kind);
}

const char* stltsa_segment_name(int32_t kind) noexcept {
    return name_in(segment_kinds, kind);
}

stltsa_status stltsa_decompose(const stltsa_clip* clip, const stltsa_options* options,
                               stltsa_decomposition** decomposition) noexcept {
    return compute([&] {
        required(decomposition, "decomposition") = nullptr;
        const clip::Clip& from = required(clip, "clip").clip;
        const capi::OptionsReader reader(options);
        *decomposition = new stltsa_decomposition(results::decompose(
            from, reader.prepare_options(), reader.decompose_options(), reader.progress()));
    });
}

void stltsa_decomposition_free(stltsa_decomposition* decomposition) noexcept {
    delete decomposition;
}

int64_t stltsa_decomposition_segment_count(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? 0 : static_cast<int64_t>(decomposition->segments.size());
}

stltsa_status stltsa_decomposition_segment(const stltsa_decomposition* decomposition, int64_t index,
                                           stltsa_segment* segment) noexcept {
    return guard([&] {
        copy_one(required(decomposition, "decomposition").segments, index, "segment",
                 required(segment, "segment"));
    });
}

const char* stltsa_decomposition_segment_reason(const stltsa_decomposition* decomposition,
                                                int64_t index) noexcept {
    const std::string* reason =
        decomposition == nullptr ? nullptr : element(decomposition->reasons, index);
    return reason == nullptr ? "" : reason->c_str();
}

stltsa_status stltsa_decomposition_first_step(const stltsa_decomposition* decomposition,
                                              int64_t segment, double* share,
                                              double* margin) noexcept {
    return guard([&] {
        motion::Halves halves;
        copy_one(required(decomposition, "decomposition").halves, segment, "segment", halves);
        if (share != nullptr)
            *share = halves.first;
        if (margin != nullptr)
            *margin = halves.margin;
    });
}

stltsa_status stltsa_decomposition_label_likeness(const stltsa_decomposition* decomposition,
                                                  int32_t label, int32_t other,
                                                  double* likeness) noexcept {
    return guard([&] {
        const Matrix& all = required(decomposition, "decomposition").label_likeness;
        double& to = required(likeness, "likeness");
        for (const int32_t each : {label, other})
            if (each < 0 || each >= all.rows())
                fail(Status::argument, "label {} is out of range: there are {}", each, all.rows());
        to = all(label, other);
    });
}

const char* stltsa_decomposition_steps_reason(const stltsa_decomposition* decomposition,
                                              int64_t segment) noexcept {
    const motion::Halves* halves =
        decomposition == nullptr ? nullptr : element(decomposition->halves, segment);
    return halves == nullptr ? "" : halves->reason.c_str();
}

int32_t stltsa_decomposition_side(const stltsa_decomposition* decomposition,
                                  int32_t side) noexcept {
    return decomposition == nullptr ? STLTSA_SIDE_NONE
                                    : static_cast<int32_t>(decomposition->named_side(side));
}

int64_t stltsa_decomposition_carrier_count(const stltsa_decomposition* decomposition,
                                           int64_t segment) noexcept {
    const auto* names =
        decomposition == nullptr ? nullptr : element(decomposition->carriers, segment);
    return names == nullptr ? 0 : static_cast<int64_t>(names->size());
}

const char* stltsa_decomposition_carrier(const stltsa_decomposition* decomposition, int64_t segment,
                                         int64_t index) noexcept {
    const auto* names =
        decomposition == nullptr ? nullptr : element(decomposition->carriers, segment);
    const std::string* name = names == nullptr ? nullptr : element(*names, index);
    return name == nullptr ? "" : name->c_str();
}

int64_t stltsa_decomposition_part_count(const stltsa_decomposition* decomposition,
                                        int32_t kind) noexcept {
    return decomposition == nullptr ? 0
                                    : static_cast<int64_t>(decomposition->parts(kind).parts.size());
}

stltsa_status stltsa_decomposition_part(const stltsa_decomposition* decomposition, int32_t kind,
                                        int64_t index, stltsa_part* part) noexcept {
    return guard([&] {
        required(part, "part");
        copy_one(parts_of(decomposition, kind).parts, index, "part", *part);
    });
}

stltsa_status stltsa_decomposition_travel(const stltsa_decomposition* decomposition, int32_t kind,
                                          int64_t index, stltsa_travel* travel) noexcept {
    return guard([&] {
        required(travel, "travel");
        copy_one(parts_of(decomposition, kind).travels, index, "part", *travel);
    });
}

stltsa_status stltsa_decomposition_statistics(const stltsa_decomposition* decomposition,
                                              int32_t kind, int32_t label, int32_t side,
                                              int32_t quantity,
                                              stltsa_statistics* statistics) noexcept {
    return guard([&] {
        required(statistics, "statistics");
        const results::Parts parts = parts_of(decomposition, kind);
        if (side < -1 || side > 1)
            fail(Status::argument, "side is {}; it must be 0, 1 or, for both, -1", side);
        if (quantity < STLTSA_QUANTITY_TIME || quantity > STLTSA_QUANTITY_TURN)
            fail(Status::argument,
                 "quantity is {}; it must be STLTSA_QUANTITY_TIME, _WAY, _STRIDE, _SPEED or _TURN",
                 quantity);
        *statistics = results::statistics_of(decomposition->segments, parts, label, side, quantity);
    });
}

int64_t stltsa_decomposition_summary_count(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? 0 : static_cast<int64_t>(decomposition->summaries.size());
}

stltsa_status stltsa_decomposition_summary(const stltsa_decomposition* decomposition, int64_t index,
                                           stltsa_summary* summary) noexcept {
    return guard([&] {
        copy_one(required(decomposition, "decomposition").summaries, index, "summary",
                 required(summary, "summary"));
    });
}

int64_t stltsa_decomposition_unit_count(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? 0 : static_cast<int64_t>(decomposition->units.size());
}

stltsa_status stltsa_decomposition_unit(const stltsa_decomposition* decomposition, int64_t index,
                                        stltsa_interval* unit) noexcept {
    return guard([&] {
        copy_one(required(decomposition, "decomposition").units, index, "unit",
                 required(unit, "unit"));
    });
}

int64_t stltsa_decomposition_cycle_count(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? 0 : static_cast<int64_t>(decomposition->cycles.size());
}

stltsa_status stltsa_decomposition_cycle(const stltsa_decomposition* decomposition, int64_t index,
                                         stltsa_interval* cycle) noexcept {
    return guard([&] {
        copy_one(required(decomposition, "decomposition").cycles, index, "cycle",
                 required(cycle, "cycle"));
    });
}

stltsa_status stltsa_decomposition_curve(const stltsa_decomposition* decomposition,
                                         const stltsa_out* curve) noexcept {
    return guard([&] {
        capi::write_column(curve, "curve", required(decomposition, "decomposition").curve.curve);
    });
}

stltsa_status stltsa_decomposition_coords(const stltsa_decomposition* decomposition,
                                          const stltsa_out* coords) noexcept {
    return guard([&] {
        capi::write_output(coords, "coords",
                           required(decomposition, "decomposition").curve.coords.view());
    });
}

stltsa_status stltsa_decomposition_loop(const stltsa_decomposition* decomposition,
                                        const stltsa_out* loop) noexcept {
    return guard([&] {
        capi::write_output(loop, "loop",
                           required(decomposition, "decomposition").curve.coords.view());
    });
}

const char* stltsa_decomposition_reason(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? "" : decomposition->reason.c_str();
}

int64_t stltsa_decomposition_warning_count(const stltsa_decomposition* decomposition) noexcept {
    return decomposition == nullptr ? 0 : static_cast<int64_t>(decomposition->warnings.size());
}

const char* stltsa_decomposition_warning(const stltsa_decomposition* decomposition,
                                         int64_t index) noexcept {
    if (index < 0 || index >= stltsa_decomposition_warning_count(decomposition))
        return "";
    return decomposition->warnings[static_cast<std::size_t>(index)].text.c_str();
}

stltsa_status stltsa_decomposition_json(const stltsa_decomposition* decomposition,
                                        char** json) noexcept {
    return guard([&] {
        required(json, "json") = nullptr;
        *json =
            capi::caller_string(capi::decomposition_json(required(decomposition, "decomposition")));
    });
}
