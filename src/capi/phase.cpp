// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <initializer_list>
#include <span>
#include <vector>

#include "base/numbers.hpp"
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

/// Writes an output that may be NULL.
void write_wanted(const stltsa_out* out, const char* name, const Matrix& values) {
    if (out != nullptr)
        capi::write_output(out, name, values.view());
}

void check_wanted(const stltsa_out* out, const char* name, const Matrix& values) {
    if (out != nullptr)
        capi::check_output(out, name, values.rows(), values.cols());
}

Matrix column(const std::vector<double>& values) {
    Matrix result(static_cast<int64_t>(values.size()), 1);
    std::ranges::copy(values, result.data());
    return result;
}

struct Wanted {
    const stltsa_out* out;
    const char* name;
    const Matrix& values;
};

/// All or, after an error, none.
void write_all(std::initializer_list<Wanted> all) {
    for (const Wanted& wanted : all)
        check_wanted(wanted.out, wanted.name, wanted.values);
    for (const Wanted& wanted : all)
        write_wanted(wanted.out, wanted.name, wanted.values);
}

} // namespace

stltsa_status stltsa_phase_find(const stltsa_decomposition* decomposition,
                                const stltsa_options* options, stltsa_phase** phase) noexcept {
    return compute([&] {
        required(phase, "phase") = nullptr;
        const results::Decomposed& of = required(decomposition, "decomposition");
        const capi::OptionsReader reader(options);
        *phase = new stltsa_phase{results::phase_of(of, reader.progress())};
    });
}

void stltsa_phase_free(stltsa_phase* phase) noexcept {
    delete phase;
}

stltsa_status stltsa_phase_values(const stltsa_phase* phase, const stltsa_out* values,
                                  const stltsa_out* residual, const stltsa_out* cycle) noexcept {
    return guard([&] {
        const results::Phased& found = required(phase, "phase");
        if (cycle != nullptr)
            capi::check_integers(cycle, "cycle", found.clip.frames);
        write_all({{values, "values", column(found.phase)},
                   {residual, "residual", column(found.residual)}});
        if (cycle != nullptr)
            capi::write_integers(cycle, "cycle", found.cycle);
    });
}

stltsa_status stltsa_phase_zero(const stltsa_phase* phase, int32_t label, double* zero) noexcept {
    return guard([&] {
        required(zero, "zero") = none;
        const results::Phased& of = required(phase, "phase");
        *zero = results::motion_of(of, label).phases.zero;
    });
}

int64_t stltsa_phase_warning_count(const stltsa_phase* phase) noexcept {
    return phase == nullptr ? 0 : static_cast<int64_t>(phase->found->warnings.size());
}

const char* stltsa_phase_warning(const stltsa_phase* phase, int64_t index) noexcept {
    if (index < 0 || index >= stltsa_phase_warning_count(phase))
        return "";
    return phase->found->warnings[static_cast<std::size_t>(index)].c_str();
}

int64_t stltsa_phase_column_count(const stltsa_phase* phase) noexcept {
    return phase == nullptr ? 0 : static_cast<int64_t>(phase->found->owners.size());
}

const char* stltsa_phase_column_owner(const stltsa_phase* phase, int64_t index) noexcept {
    if (index < 0 || index >= stltsa_phase_column_count(phase))
        return "";
    return phase->found->owners[static_cast<std::size_t>(index)].c_str();
}

stltsa_status stltsa_cycles_resample(const stltsa_phase* phase, int32_t label,
                                     const stltsa_in* signals, int64_t samples,
                                     stltsa_cycles** cycles) noexcept {
    return compute([&] {
        required(cycles, "cycles") = nullptr;
        const results::Phased& by = required(phase, "phase");
        const capi::InputFrames input(signals, "signals");
        capi::check_samples(samples);
        *cycles = new stltsa_cycles(results::resample(by, label, input.view(), samples));
    });
}

stltsa_status stltsa_cycles_between(const stltsa_in* borders, const stltsa_in* signals,
                                    int64_t samples, stltsa_cycles** cycles) noexcept {
    return compute([&] {
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
        *cycles = new stltsa_cycles(
            phase::resample(input.view(), {phase::times_between(rows, samples), {}}));
    });
}

void stltsa_cycles_free(stltsa_cycles* cycles) noexcept {
    delete cycles;
}

int64_t stltsa_cycles_count(const stltsa_cycles* cycles) noexcept {
    return cycles == nullptr ? 0 : static_cast<int64_t>(cycles->each.size());
}

stltsa_status stltsa_cycles_mean(const stltsa_cycles* cycles, const stltsa_out* mean,
                                 const stltsa_out* deviation) noexcept {
    return guard([&] {
        const phase::Resampled& of = required(cycles, "cycles");
        write_all({{mean, "mean", of.mean}, {deviation, "deviation", of.deviation}});
    });
}

stltsa_status stltsa_cycles_cycle(const stltsa_cycles* cycles, int64_t index,
                                  const stltsa_out* values) noexcept {
    return guard([&] {
        const auto& each = required(cycles, "cycles").each;
        if (index < 0 || index >= static_cast<int64_t>(each.size()))
            fail(Status::argument, "cycle {} does not exist: there are {}", index, each.size());
        capi::write_output(values, "values", each[static_cast<std::size_t>(index)].view());
    });
}

stltsa_status stltsa_cycles_times(const stltsa_cycles* cycles, const stltsa_out* frames,
                                  const stltsa_out* warp) noexcept {
    return guard([&] {
        const phase::Resampled& of = required(cycles, "cycles");
        write_all({{frames, "frames", of.rows}, {warp, "warp", of.warp}});
    });
}

stltsa_status stltsa_cycles_distance(const stltsa_cycles* cycles, const stltsa_out* total,
                                     const stltsa_out* columns) noexcept {
    return guard([&] {
        const phase::Resampled& of = required(cycles, "cycles");
        write_all({{total, "total", column(of.total)}, {columns, "columns", of.distance}});
    });
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
