// SPDX-License-Identifier: BSD-3-Clause
// The rows of comparisons.
#pragma once

#include "capi/handles.hpp"

namespace stltsa::capi {

inline stltsa_estimate estimate_row(const phase::Estimate& of) {
    return {of.first, of.first_sd, of.second, of.second_sd,          of.difference,
            of.error, of.low,      of.high,   of.significant ? 1 : 0};
}

inline stltsa_compared compared_row(const Comparison& of) {
    return {of.sides ? 1 : 0,
            static_cast<std::int64_t>(of.features),
            of.samples,
            of.shift.difference,
            of.shift.error,
            of.shift.low,
            of.shift.high,
            of.likeness,
            of.runner_up,
            of.turn,
            of.size_ratio,
            estimate_row(of.cycle_time),
            of.judged,
            of.significant,
            expected_by_chance(of)};
}

inline stltsa_compared_motion motion_row(const stltsa_comparison& of, std::size_t which) {
    const ComparedMotion& motion = of.motions[which];
    const double time = which == 0 ? of.cycle_time.first : of.cycle_time.second;
    return {motion.clip.path.c_str(),
            motion.clip.frames,
            motion.clip.fps > 0 ? motion.clip.fps : none,
            motion.label,
            of.letters[which].c_str(),
            motion.cycles,
            60 / time,
            of.left_out[which]};
}

/// `channel`: its axis; "" of a part.
inline stltsa_compared_part part_row(const Comparison& of, const phase::PartDifference& found,
                                     std::size_t part, const char* axis) {
    const double cycle = mean_cycle_time(of);
    return {static_cast<std::int64_t>(part),
            of.columns.names[part].c_str(),
            of.columns.other_names[part].c_str(),
            axis,
            estimate_row(found.mean),
            estimate_row(found.lag),
            {found.lag.difference * cycle, found.lag.low * cycle, found.lag.high * cycle},
            estimate_row(found.amplitude),
            {found.ratio.difference, found.ratio.low, found.ratio.high},
            found.rms,
            found.chance,
            found.correlation};
}

inline constexpr auto compared_motion_row = [](const stltsa_comparison& of, std::size_t which) {
    return motion_row(of, which);
};
inline constexpr auto compared_part_row = [](const stltsa_comparison& of, std::size_t index) {
    return part_row(of, of.differences.parts[index], index, "");
};
inline constexpr auto compared_channel_row = [](const stltsa_comparison& of, std::size_t index) {
    return part_row(of, of.differences.columns[index],
                    static_cast<std::size_t>(of.columns.part[index]),
                    of.columns.axis[index].c_str());
};

} // namespace stltsa::capi
