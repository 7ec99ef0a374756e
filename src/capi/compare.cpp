// SPDX-License-Identifier: BSD-3-Clause
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/side_name.hpp"
#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/boundary/structs.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;
using results::Comparison;

namespace {

/// More samples add nothing to a cycle, and the time rises with their square: each point of a curve
/// is compared with every other.
constexpr int64_t least_samples = 5, most_samples = 1001;

std::optional<int32_t> wanted(int32_t label) {
    return label == -1 ? std::nullopt : std::optional(label);
}

stltsa_estimate made(const phase::Estimate& of) {
    return {of.first, of.first_sd, of.second, of.second_sd,           of.difference,
            of.error, of.low,      of.high,   of.significant ? 1 : 0, 0};
}

void check_which(int32_t which) {
    if (which != 0 && which != 1)
        fail(Status::argument, "which is {}; it must be 0 for the first motion, 1 for the second",
             which);
}

/// `part_of`: the part to which each element of `all` belongs; empty: each is a part itself.
void give_part(const Comparison& of, const std::vector<phase::PartDifference>& all,
               const std::vector<int64_t>& part_of, int64_t index, stltsa_compared_part* to,
               const char* name) {
    if (index < 0 || index >= std::ssize(all))
        fail(Status::argument, "{} {} does not exist: there are {}", name, index, all.size());
    const auto at = static_cast<std::size_t>(index);
    const phase::PartDifference& found = all[at];
    const int64_t part = part_of.empty() ? index : part_of[at];
    const double cycle = results::mean_cycle_time(of);
    const stltsa_compared_part copy = {sizeof(stltsa_compared_part),
                                       part,
                                       found.rms,
                                       found.chance,
                                       found.correlation,
                                       made(found.lag),
                                       made(found.amplitude),
                                       found.ratio.difference,
                                       found.ratio.low,
                                       found.ratio.high,
                                       found.lag.difference * cycle,
                                       found.lag.low * cycle,
                                       found.lag.high * cycle,
                                       made(found.mean)};
    capi::give(copy, to, name, "stltsa_compared_part");
}

const std::string* text_at(const std::vector<std::string>* texts, int64_t index) {
    if (texts == nullptr || index < 0 || index >= static_cast<int64_t>(texts->size()))
        return nullptr;
    return &(*texts)[static_cast<std::size_t>(index)];
}

const char* text_or_empty(const std::string* text) {
    return text == nullptr ? "" : text->c_str();
}

const std::vector<std::string>* left_out(const stltsa_comparison* comparison, int32_t which) {
    if (comparison == nullptr || (which != 0 && which != 1))
        return nullptr;
    return which == 0 ? &comparison->columns.left_out : &comparison->columns.other_left_out;
}

struct Wanted {
    const stltsa_out* out;
    const char* name;
    const Matrix& values;
};

std::vector<std::string> names_of(const char* const* names, int64_t columns) {
    required(names, "names");
    std::vector<std::string> texts;
    for (int64_t c = 0; c < columns; ++c) {
        if (names[c] == nullptr)
            fail(Status::argument, "name {} is NULL; use \"\" for a column without a name", c);
        texts.emplace_back(names[c]);
    }
    return texts;
}

/// Writes all or, after an error, none.
void write_all(std::initializer_list<Wanted> all) {
    for (const Wanted& each : all)
        if (each.out != nullptr)
            capi::check_output(each.out, each.name, each.values.rows(), each.values.cols());
    for (const Wanted& each : all)
        if (each.out != nullptr)
            capi::write_output(each.out, each.name, each.values.view());
}

} // namespace

static_assert(static_cast<int32_t>(Side::left) == STLTSA_SIDE_LEFT &&
              static_cast<int32_t>(Side::right) == STLTSA_SIDE_RIGHT &&
              static_cast<int32_t>(Side::neither) == STLTSA_SIDE_NONE);

int32_t stltsa_side_of_name(const char* name) noexcept {
    return name == nullptr ? STLTSA_SIDE_NONE : static_cast<int32_t>(side_of_name(name));
}

stltsa_status stltsa_compare(const stltsa_phase* first, int32_t first_label,
                             const stltsa_phase* second, int32_t second_label, int64_t samples,
                             stltsa_comparison** comparison) noexcept {
    return stltsa_compare_with(first, first_label, second, second_label, samples, nullptr,
                               comparison);
}

stltsa_status stltsa_compare_with(const stltsa_phase* first, int32_t first_label,
                                  const stltsa_phase* second, int32_t second_label, int64_t samples,
                                  const stltsa_options* options,
                                  stltsa_comparison** comparison) noexcept {
    return compute([&] {
        required(comparison, "comparison") = nullptr;
        const results::Phased& one = required(first, "first");
        const results::Phased& other = required(second, "second");
        capi::check_samples(samples, least_samples, most_samples);
        const capi::OptionsReader reader(options);
        *comparison = new stltsa_comparison(results::compare(
            one, wanted(first_label), other, wanted(second_label), samples, reader.progress()));
    });
}

stltsa_status stltsa_compare_left_right(const stltsa_clip* clip, const stltsa_phase* phase,
                                        int32_t label, int64_t samples,
                                        const stltsa_options* options,
                                        stltsa_comparison** comparison) noexcept {
    return compute([&] {
        required(comparison, "comparison") = nullptr;
        const clip::Clip& of = required(clip, "clip").clip;
        const results::Phased& by = required(phase, "phase");
        capi::check_samples(samples, least_samples, most_samples);
        const capi::OptionsReader reader(options);
        *comparison = new stltsa_comparison(results::compare_left_right(
            of, by, wanted(label), samples, reader.prepare_options(), reader.progress()));
    });
}

stltsa_status stltsa_cycles_compare_left_right(const stltsa_cycles* cycles,
                                               const char* const* names, double fps,
                                               const stltsa_options* options,
                                               stltsa_comparison** comparison) noexcept {
    return compute([&] {
        required(comparison, "comparison") = nullptr;
        const phase::Resampled& of = required(cycles, "cycles");
        capi::check_samples(of.mean.rows(), least_samples, most_samples);
        if (fps != 0)
            capi::check_rate(fps);
        const capi::OptionsReader reader(options);
        *comparison = new stltsa_comparison(results::compare_left_right(
            of, names_of(names, of.mean.cols()), fps, reader.progress()));
    });
}

void stltsa_comparison_free(stltsa_comparison* comparison) noexcept {
    delete comparison;
}

stltsa_status stltsa_comparison_cycles(const stltsa_comparison* comparison,
                                       stltsa_compared_cycles* cycles) noexcept {
    return guard([&] {
        const Comparison& of = required(comparison, "comparison");
        const stltsa_compared_cycles copy = {sizeof(stltsa_compared_cycles),
                                             of.motions[0].cycles,
                                             of.motions[1].cycles,
                                             of.motions[0].label,
                                             of.motions[1].label,
                                             of.samples,
                                             made(of.cycle_time),
                                             60 / of.cycle_time.first,
                                             60 / of.cycle_time.second,
                                             of.shift.difference,
                                             of.shift.error,
                                             of.shift.low,
                                             of.shift.high,
                                             of.likeness,
                                             of.runner_up,
                                             of.turn,
                                             of.size_ratio,
                                             of.judged,
                                             of.significant,
                                             of.sides ? 1 : 0,
                                             0};
        capi::give(copy, cycles, "cycles", "stltsa_compared_cycles");
    });
}

int64_t stltsa_comparison_part_count(const stltsa_comparison* comparison) noexcept {
    return comparison == nullptr ? 0 : static_cast<int64_t>(comparison->columns.names.size());
}

stltsa_status stltsa_comparison_part(const stltsa_comparison* comparison, int64_t index,
                                     stltsa_compared_part* part) noexcept {
    return guard([&] {
        const Comparison& of = required(comparison, "comparison");
        give_part(of, of.differences.parts, {}, index, part, "part");
    });
}

const char* stltsa_comparison_part_name(const stltsa_comparison* comparison, int32_t which,
                                        int64_t index) noexcept {
    if (comparison == nullptr || (which != 0 && which != 1))
        return "";
    return text_or_empty(
        text_at(which == 0 ? &comparison->columns.names : &comparison->columns.other_names, index));
}

int64_t stltsa_comparison_channel_count(const stltsa_comparison* comparison) noexcept {
    return comparison == nullptr ? 0 : static_cast<int64_t>(comparison->columns.axis.size());
}

stltsa_status stltsa_comparison_channel(const stltsa_comparison* comparison, int64_t index,
                                        stltsa_compared_part* channel) noexcept {
    return guard([&] {
        const Comparison& of = required(comparison, "comparison");
        give_part(of, of.differences.columns, of.columns.part, index, channel, "channel");
    });
}

const char* stltsa_comparison_channel_axis(const stltsa_comparison* comparison,
                                           int64_t index) noexcept {
    return text_or_empty(
        text_at(comparison == nullptr ? nullptr : &comparison->columns.axis, index));
}

stltsa_status stltsa_comparison_curves(const stltsa_comparison* comparison, int32_t which,
                                       const stltsa_out* mean,
                                       const stltsa_out* deviation) noexcept {
    return guard([&] {
        const Comparison& all = required(comparison, "comparison");
        check_which(which);
        const results::ComparedMotion& of = all.motions[static_cast<std::size_t>(which)];
        write_all({{mean, "mean", of.mean}, {deviation, "deviation", of.deviation}});
    });
}

stltsa_status stltsa_comparison_difference(const stltsa_comparison* comparison,
                                           const stltsa_out* difference,
                                           const stltsa_out* standard_error,
                                           const stltsa_out* margin) noexcept {
    return guard([&] {
        const phase::Differences& of = required(comparison, "comparison").differences;
        write_all({{difference, "difference", of.difference},
                   {standard_error, "standard_error", of.error},
                   {margin, "margin", of.margin}});
    });
}

int64_t stltsa_comparison_left_out_count(const stltsa_comparison* comparison,
                                         int32_t which) noexcept {
    const std::vector<std::string>* names = left_out(comparison, which);
    return names == nullptr ? 0 : static_cast<int64_t>(names->size());
}

const char* stltsa_comparison_left_out(const stltsa_comparison* comparison, int32_t which,
                                       int64_t index) noexcept {
    return text_or_empty(text_at(left_out(comparison, which), index));
}

int64_t stltsa_comparison_warning_count(const stltsa_comparison* comparison) noexcept {
    return comparison == nullptr ? 0 : static_cast<int64_t>(comparison->warnings.size());
}

const char* stltsa_comparison_warning(const stltsa_comparison* comparison, int64_t index) noexcept {
    return text_or_empty(text_at(comparison == nullptr ? nullptr : &comparison->warnings, index));
}

stltsa_status stltsa_comparison_json(const stltsa_comparison* comparison, char** json) noexcept {
    return guard([&] {
        required(json, "json") = nullptr;
        *json = capi::caller_string(capi::comparison_json(required(comparison, "comparison")));
    });
}
