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

std::optional<std::int64_t> wanted(int64_t label) {
    return label == -1 ? std::nullopt : std::optional(label);
}

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

} // namespace

static_assert(static_cast<int32_t>(Side::left) == STLTSA_SIDE_LEFT &&
              static_cast<int32_t>(Side::right) == STLTSA_SIDE_RIGHT &&
              static_cast<int32_t>(Side::neither) == STLTSA_SIDE_NONE);

int32_t stltsa_side_of_name(const char* name) noexcept {
    return name == nullptr ? STLTSA_SIDE_NONE : static_cast<int32_t>(side_of_name(name));
}

stltsa_status stltsa_compare(const stltsa_phase* first, int64_t first_label,
                             const stltsa_phase* second, int64_t second_label, int64_t samples,
                             const stltsa_options* options,
                             stltsa_comparison** comparison) noexcept {
    return compute(options, [&] {
        required(comparison, "comparison") = nullptr;
        const results::Phased& one = required(first, "first");
        const results::Phased& other = required(second, "second");
        capi::check_samples(samples, least_samples, most_samples);
        *comparison = new stltsa_comparison(
            results::compare(one, wanted(first_label), other, wanted(second_label), samples));
    });
}

stltsa_status stltsa_compare_left_right(const stltsa_clip* clip, const stltsa_phase* phase,
                                        int64_t label, int64_t samples,
                                        const stltsa_options* options,
                                        stltsa_comparison** comparison) noexcept {
    return compute(options, [&] {
        required(comparison, "comparison") = nullptr;
        const clip::Clip& of = required(clip, "clip").clip;
        const results::Phased& by = required(phase, "phase");
        capi::check_samples(samples, least_samples, most_samples);
        const capi::OptionsReader reader(options);
        *comparison = new stltsa_comparison(
            results::compare_left_right(of, by, wanted(label), samples, reader.prepare_options()));
    });
}

stltsa_status stltsa_cycles_compare_left_right(const stltsa_cycles* cycles,
                                               const char* const* names, double fps,
                                               const stltsa_options* options,
                                               stltsa_comparison** comparison) noexcept {
    return compute(options, [&] {
        required(comparison, "comparison") = nullptr;
        const phase::Resampled& of = required(cycles, "cycles");
        capi::check_samples(of.mean.rows(), least_samples, most_samples);
        if (fps != 0)
            capi::check_rate(fps);
        *comparison = new stltsa_comparison(
            results::compare_left_right(of, names_of(names, of.mean.cols()), fps));
    });
}

void stltsa_comparison_free(stltsa_comparison* comparison) noexcept {
    delete comparison;
}
