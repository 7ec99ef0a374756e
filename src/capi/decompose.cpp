// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <memory>

#include "capi/arrays.hpp"
#include "capi/guard.hpp"
#include "capi/source.hpp"
#include "clip/features.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

constexpr bool same(motion::UnitKind kind, int value) {
    return static_cast<int>(kind) == value;
}
static_assert(same(motion::UnitKind::preparing, STLTSA_UNIT_PREPARING) &&
              same(motion::UnitKind::initial, STLTSA_UNIT_INITIAL) &&
              same(motion::UnitKind::cyclic, STLTSA_UNIT_CYCLIC) &&
              same(motion::UnitKind::final, STLTSA_UNIT_FINAL) &&
              same(motion::UnitKind::wind_up, STLTSA_UNIT_WIND_UP) &&
              same(motion::UnitKind::action, STLTSA_UNIT_ACTION));

/// Maps positions among the working samples to the source file.
class SourceFrames {
  public:
    SourceFrames(const capi::Source& source)
        : samples_(source.samples), clip_(source.clips.front()) {}

    stltsa_interval interval(double begin, double end, int32_t kind) const {
        const double first = frame(begin);
        const double last = frame(end);
        return {
            std::llround(first), std::llround(last), first / clip_.fps, last / clip_.fps, kind, 0};
    }

    /// Units reach to both ends of the file: dropped frames belong to the first unit, frames after
    /// the last sample to the last one. What rounds to no frame is no unit, and what
    /// it kept apart is one.
    std::vector<stltsa_interval> units(const std::vector<motion::Unit>& found) const {
        std::vector<stltsa_interval> units;
        for (const motion::Unit& unit : found) {
            auto next = interval(unit.begin, unit.end, static_cast<int32_t>(unit.kind));
            next.begin = units.empty() ? 0 : units.back().end;
            next.begin_s = units.empty() ? 0 : units.back().end_s;
            if (next.end <= next.begin)
                continue;
            if (!units.empty() && units.back().kind == next.kind) {
                units.back().end = next.end;
                units.back().end_s = next.end_s;
            } else {
                units.push_back(next);
            }
        }
        if (!units.empty()) {
            units.back().end = clip_.frames;
            units.back().end_s = static_cast<double>(clip_.frames) / clip_.fps;
        }
        return units;
    }

  private:
    double frame(double sample) const {
        return static_cast<double>(samples_.first) + sample * static_cast<double>(samples_.step);
    }

    const capi::SampleFacts& samples_;
    const capi::ClipFacts& clip_;
};

motion::DecomposeOptions search_options(const capi::OptionsReader& options,
                                        const capi::Source& source, std::int64_t jump) {
    auto search = options.decompose_options();
    const double fps = source.clips.front().fps;
    search.first_s = static_cast<double>(source.samples.first) / fps;
    search.in_space = source.samples.features == clip::Features::raw;
    if (jump > 0) {
        search.jump_s = static_cast<double>(jump) / fps;
        search.jump = format_text("frame {} ({:.2f} s)", jump, search.jump_s);
    }
    return search;
}

std::unique_ptr<stltsa_decomposition> decompose(const stltsa_clip& clip,
                                                const capi::OptionsReader& options) {
    if (!(clip.clip.fps > 0))
        fail(Status::argument, "the clip's frame rate is unknown: open it with option fps");
    const stltsa_clip* single = &clip;
    auto prepared = capi::prepare_clips({&single, 1}, options);
    auto made = std::make_unique<stltsa_decomposition>();
    made->source = std::move(prepared.source);
    const auto search = search_options(options, made->source, prepared.jump);
    made->result = motion::decompose(prepared.samples.view(), made->source.samples.fps, search,
                                     options.progress());
    made->source.period = {made->result.period / made->source.samples.fps, made->result.lag_quality,
                           search.shortest_period, search.longest_period};
    const SourceFrames frames(made->source);
    made->units = frames.units(made->result.units);
    for (const motion::Cycle& cycle : made->result.cycles)
        made->cycles.push_back(frames.interval(cycle.begin, cycle.end, STLTSA_UNIT_CYCLE));
    return made;
}

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
        *decomposition = decompose(required(clip, "clip"), capi::OptionsReader(options)).release();
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
        const auto& d = required(decomposition, "decomposition");
        *json = capi::caller_string(
            capi::decomposition_json({d.source.clip_or_null(), d.source.samples, d.source.period,
                                      &d.result, d.units, d.cycles}));
    });
}
