// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <initializer_list>
#include <span>
#include <vector>

#include "base/numbers.hpp"
#include "base/progress.hpp"
#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

namespace {

/// Throws unless there is a group for each column, and a column in a group.
void check_groups(std::span<const int64_t> groups, int64_t columns) {
    if (static_cast<int64_t>(groups.size()) != columns)
        fail(Status::shape, "groups has {} rows; the signals have {} columns", groups.size(),
             columns);
    const auto [least, most] = std::ranges::minmax(groups);
    if (least < -1 || most >= columns || most < 0)
        fail(Status::argument, "groups are {} to {}; they must be from 0 on, or -1 for no group",
             least, most);
}

/// Throws unless the borders rise and lie within the rows.
void check_borders(const phase::Borders& borders, int64_t rows) {
    if (borders.size() < 2)
        fail(Status::argument, "borders has {} values; a cycle has two borders", borders.size());
    for (std::size_t i = 0; i < borders.size(); ++i) {
        if (!(borders[i] >= 0 && borders[i] <= static_cast<double>(rows)))
            fail(Status::argument, "border {} is frame {}; the signals have frames 0 to {}", i,
                 borders[i], rows);
        if (i > 0 && !(borders[i] > borders[i - 1]))
            fail(Status::argument, "border {}, frame {}, does not come after border {}, frame {}",
                 i, borders[i], i - 1, borders[i - 1]);
    }
}

} // namespace

stltsa_status stltsa_phase_find(const stltsa_decomposition* decomposition,
                                const stltsa_options* options, stltsa_phase** phase) noexcept {
    return compute(options, [&] {
        required(phase, "phase") = nullptr;
        const results::Decomposed& of = required(decomposition, "decomposition");
        *phase = new stltsa_phase(results::phase_of(of));
    });
}

void stltsa_phase_free(stltsa_phase* phase) noexcept {
    delete phase;
}

stltsa_status stltsa_cycles_resample(const stltsa_phase* phase, int64_t label,
                                     const stltsa_in* signals, int64_t samples,
                                     const stltsa_options* options,
                                     stltsa_cycles** cycles) noexcept {
    return compute(options, [&] {
        required(cycles, "cycles") = nullptr;
        const results::Phased& by = required(phase, "phase");
        const capi::InputFrames input(signals, "signals");
        capi::check_samples(samples);
        report_progress(Stage::units, 0);
        *cycles = new stltsa_cycles(results::resample(by, label, input.view(), samples));
    });
}

stltsa_status stltsa_cycles_between(const stltsa_in* borders, const stltsa_in* signals,
                                    int64_t samples, const stltsa_options* options,
                                    stltsa_cycles** cycles) noexcept {
    return compute(options, [&] {
        required(cycles, "cycles") = nullptr;
        const capi::InputFrames of(borders, "borders");
        const capi::InputFrames input(signals, "signals");
        if (of.view().cols != 1)
            fail(Status::shape, "borders has {} columns; it must have 1", of.view().cols);
        capi::check_samples(samples);
        phase::Borders rows;
        for (int64_t i = 0; i < of.view().rows; ++i)
            rows.push_back(of.view()(i, 0));
        check_borders(rows, input.view().rows);
        report_progress(Stage::units, 0);
        *cycles = new stltsa_cycles(
            phase::resample(input.view(), {phase::times_between(rows, samples), {}}));
    });
}

void stltsa_cycles_free(stltsa_cycles* cycles) noexcept {
    delete cycles;
}

stltsa_status stltsa_cycles_group_distance(const stltsa_cycles* cycles, const stltsa_in* groups,
                                           const stltsa_out* distance) noexcept {
    return guard([&] {
        const phase::Resampled& of = required(cycles, "cycles");
        const std::vector<int64_t> group_of = capi::input_integers(groups, "groups");
        check_groups(group_of, of.distance.cols());
        capi::write_output(distance, "distance", phase::group_distance(of, group_of).view());
    });
}
