// SPDX-License-Identifier: BSD-3-Clause
#include "base/names.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

namespace {

// The values of motion::UnitKind and motion::SegmentKind are those of the header.
constexpr bool same(motion::UnitKind kind, int value) {
    return static_cast<int>(kind) == value;
}
static_assert(same(motion::UnitKind::preparing, STLTSA_UNIT_PREPARING) &&
              same(motion::UnitKind::initial, STLTSA_UNIT_INITIAL) &&
              same(motion::UnitKind::cyclic, STLTSA_UNIT_CYCLIC) &&
              same(motion::UnitKind::final, STLTSA_UNIT_FINAL) &&
              same(motion::UnitKind::wind_up, STLTSA_UNIT_WIND_UP) &&
              same(motion::UnitKind::action, STLTSA_UNIT_ACTION) &&
              same(motion::UnitKind::hold, STLTSA_UNIT_HOLD));
constexpr bool same(motion::SegmentKind kind, int value) {
    return static_cast<int>(kind) == value;
}
static_assert(same(motion::SegmentKind::cyclic, STLTSA_SEGMENT_CYCLIC) &&
              same(motion::SegmentKind::repetitions, STLTSA_SEGMENT_REPETITIONS) &&
              same(motion::SegmentKind::action, STLTSA_SEGMENT_ACTION) &&
              same(motion::SegmentKind::rest, STLTSA_SEGMENT_REST));

} // namespace

const char* stltsa_unit_name(int64_t kind) noexcept {
    return name_of(unit_kinds, kind);
}

const char* stltsa_segment_name(int64_t kind) noexcept {
    return name_of(segment_kinds, kind);
}

stltsa_status stltsa_decompose(const stltsa_clip* clip, const stltsa_options* options,
                               stltsa_decomposition** decomposition) noexcept {
    return compute(options, [&] {
        required(decomposition, "decomposition") = nullptr;
        const clip::Clip& from = required(clip, "clip").clip;
        const capi::OptionsReader reader(options);
        *decomposition = new stltsa_decomposition(
            results::decompose(from, reader.prepare_options(), reader.decompose_options()));
    });
}

void stltsa_decomposition_free(stltsa_decomposition* decomposition) noexcept {
    delete decomposition;
}

stltsa_status stltsa_decomposition_statistics(const stltsa_decomposition* decomposition,
                                              int32_t kind, int64_t label, int32_t side,
                                              int32_t quantity,
                                              stltsa_statistics* statistics) noexcept {
    return guard([&] {
        required(statistics, "statistics");
        const results::Decomposed& of = required(decomposition, "decomposition");
        if (kind != STLTSA_INFO_CYCLE && kind != STLTSA_INFO_STEP && kind != STLTSA_INFO_REPETITION)
            fail(Status::argument, "kind is {}; it must be STLTSA_INFO_CYCLE, _STEP or _REPETITION",
                 kind);
        if (side < -1 || side > 1)
            fail(Status::argument, "side is {}; it must be 0, 1 or, for both, -1", side);
        if (quantity < STLTSA_QUANTITY_TIME || quantity > STLTSA_QUANTITY_TURN)
            fail(Status::argument,
                 "quantity is {}; it must be STLTSA_QUANTITY_TIME, _PATH_LENGTH, _STRIDE, _SPEED "
                 "or _TURN",
                 quantity);
        *statistics = results::statistics_of(of.parts(kind), label, side, quantity);
    });
}
