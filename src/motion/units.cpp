// SPDX-License-Identifier: BSD-3-Clause
#include "motion/units.hpp"

#include <algorithm>
#include <cmath>

#include "motion/curve/statistics.hpp"
#include "motion/rests.hpp"

namespace stltsa::motion {
namespace {

/// Next to cycles, the body stands if it is slower than this share of their median speed for this
/// share of the period. Gait stays above 0.45; the noise of a standing body stays below the limit.
constexpr double standing_beside_cycles = 0.4;
constexpr double hold_periods = 0.25;
constexpr double still_beside_cycles = 0.25;
/// Without cycles, it stands if it is slower than this share of the typical speed for this long.
constexpr double standing_among_actions = 0.25;
constexpr double hold_s = 0.3;
constexpr double still_among_actions = 0.15;
/// Slower cycles start with a slower first step, which permits more smoothing: it then displaces
/// all starts by the same share of a cycle and removes as much noise as possible.
constexpr double smoothing_periods = 0.14;
/// Even slow exercises start within this time.
constexpr double most_smoothing_s = 0.2;
/// Motion that covers less than this share of a cycle's distance is fidgeting.
constexpr double least_motion_cycles = 0.5;

void append(std::vector<Unit>& units, UnitKind kind, double begin, double end) {
    if (end > begin)
        units.push_back({kind, begin, end});
}

/// Median speed and length of a cycle.
struct Pace {
    double speed = 0;
    double period = 0;
};

/// Whether this is more than fidgeting: the distance covered in excess of standing speed is at
/// least the given share of that of a cycle.
bool is_motion(std::span<const double> speed, const Pace& pace) {
    const double standing = standing_beside_cycles * pace.speed;
    double distance = 0;
    for (const double v : speed)
        distance += std::max(v - standing, 0.0);
    return distance >= least_motion_cycles * (pace.speed - standing) * pace.period;
}

/// Appends units that cover `all`, the preparing or wind-up unit, with the motions between its
/// rests as actions.
void append_standing(std::vector<Unit>& units, Unit all, std::vector<Rest> rests,
                     std::span<const double> speed, const Pace& pace) {
    rests.push_back({all.end, all.end});
    double stands = all.begin; // start of the current standing
    double moves = all.begin;  // end of the previous rest
    for (const Rest& rest : rests) {
        if (rest.begin < all.begin || rest.end > all.end)
            continue;
        const auto first = static_cast<std::size_t>(moves);
        const auto end = static_cast<std::size_t>(rest.begin);
        if (end > first && is_motion(speed.subspan(first, end - first), pace)) {
            append(units, all.kind, stands, moves);
            append(units, UnitKind::action, moves, rest.begin);
            stands = rest.begin;
        }
        moves = rest.end;
    }
    append(units, all.kind, stands, all.end);
}

} // namespace

double border_smoothing(double period, double fps) {
    return std::min(smoothing_periods * period, most_smoothing_s * fps);
}

std::vector<Unit> cyclic_units(const std::vector<double>& margins, std::span<const double> speed,
                               double period) {
    const auto samples = static_cast<double>(speed.size());
    const auto first = static_cast<std::size_t>(std::lround(margins.front()));
    const auto last = static_cast<std::size_t>(std::lround(margins.back()));
    const double reference = median(speed.subspan(first, last + 1 - first));
    double moves = 0;
    double stops = samples;
    const Standing standing{standing_beside_cycles * reference, hold_periods * period,
                            still_beside_cycles * reference};
    const std::vector<Rest> rests = find_rests(speed, standing);
    for (const Rest& rest : rests) {
        if (rest.end <= margins.front())
            moves = rest.end;
        if (rest.begin >= margins.back())
            stops = std::min(stops, rest.begin);
    }
    std::vector<Unit> units;
    append_standing(units, {UnitKind::preparing, 0, moves}, rests, speed, {reference, period});
    append(units, UnitKind::initial, moves, margins.front());
    append(units, UnitKind::cyclic, margins.front(), margins.back());
    append(units, UnitKind::final, margins.back(), stops);
    append_standing(units, {UnitKind::wind_up, stops, samples}, rests, speed, {reference, period});
    return units;
}

std::vector<Unit> action_units(const Activity& activity, double fps) {
    const auto end = static_cast<double>(activity.samples());
    if (!(activity.typical > 0))
        return {{UnitKind::preparing, 0, end}};
    std::vector<Unit> units;
    double done = 0;
    const Standing standing{standing_among_actions * activity.typical, hold_s * fps,
                            still_among_actions * activity.typical};
    for (const Rest& rest : find_rests(activity.speed, standing)) {
        append(units, UnitKind::action, done, rest.begin);
        const bool winds_up = rest.begin > 0 && rest.end >= end;
        append(units, winds_up ? UnitKind::wind_up : UnitKind::preparing, rest.begin, rest.end);
        done = rest.end;
    }
    append(units, UnitKind::action, done, end);
    return units;
}

} // namespace stltsa::motion
