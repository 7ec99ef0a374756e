// SPDX-License-Identifier: BSD-3-Clause
#include "results/strikes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/numbers.hpp"
#include "results/events.hpp"

namespace stltsa::results {
namespace {

/// Strikes of a side that scatter more, in shares of a cycle, contradict the cycles: 0.01 is usual.
constexpr double most_scatter = 0.05;
/// One that is farther from the others is at another place of the cycle.
constexpr double one_place = 0.1;
/// Marks of one side that are closer, in cycles, are one strike.
constexpr double one_strike = 0.25;

std::string_view side_text(Side side) {
    return side == Side::left ? "left" : side == Side::right ? "right" : "of no stated side";
}

Side opposite(Side side) {
    return side == Side::left ? Side::right : side == Side::right ? Side::left : Side::neither;
}

std::string not_used(std::size_t count, Side side, const std::string& why) {
    return format_text("foot strikes of the file that are not used: {} {}; {}", count,
                       side_text(side), why);
}

/// The strikes of one side that lie in a motion.
std::vector<phase::Mark> marks_in(const phase::Searched& motion, const Phased& phased,
                                  std::span<const clip::FootStrike> stated, Side side) {
    std::vector<phase::Mark> marks;
    double sum = 0, count = 0;
    const auto add = [&] {
        if (count == 0)
            return;
        const auto mark = phase::mark_at(motion, sum / count);
        if (mark && mark->distance <= phase::other_motion)
            marks.push_back(*mark);
        sum = count = 0;
    };
    double first = 0;
    for (const clip::FootStrike& strike : stated) {
        if (strike.side != side)
            continue;
        const double row = strike.frame - static_cast<double>(phased.clip.first);
        if (count == 0 || row - first > one_strike * motion.mean.period) {
            add();
            first = row;
        }
        sum += row;
        ++count;
    }
    add();
    return marks;
}

/// Marks about their mean place in the cycle.
struct Scatter {
    phase::Place marks; ///< phases count on beyond 1, and below 0
    double mean = 0, deviation = 0;
};

/// The mean place in the cycle, -0.5 to 0.5, or in one of equal parts of it.
double mean_place(const std::vector<phase::Mark>& marks, double parts = 1) {
    double cosine = 0, sine = 0;
    for (const phase::Mark& mark : marks) {
        cosine += std::cos(parts * turn * mark.phase);
        sine += std::sin(parts * turn * mark.phase);
    }
    return std::atan2(sine, cosine) / (parts * turn);
}

Scatter scatter_of(std::vector<phase::Mark> marks) {
    const double mean = mean_place(marks);
    double squares = 0;
    for (phase::Mark& mark : marks) {
        const double off = mark.phase - mean - std::round(mark.phase - mean);
        mark.phase = mean + off;
        squares += off * off;
    }
    const double count = static_cast<double>(marks.size());
    return {std::move(marks), mean, std::sqrt(squares / count)};
}

/// Marks of one foot, and of the other, half a cycle later, if there are any. The first foot is the
/// one that strikes first after the cycles begin.
std::array<std::vector<phase::Mark>, 2> by_foot(const std::vector<phase::Mark>& marks) {
    const double mean = mean_place(marks, 2);
    const double first = mean < 0 ? mean + 0.5 : mean;
    std::array<std::vector<phase::Mark>, 2> feet;
    for (const phase::Mark& mark : marks) {
        const double off = mark.phase - first - std::round(mark.phase - first);
        feet[std::abs(off) <= 0.25 ? 0 : 1].push_back(mark);
    }
    return feet;
}

/// The strikes of one side in a motion.
struct SideStrikes {
    Side side = Side::neither;
    std::size_t stated = 0;
    std::vector<double> frames; ///< empty: there are none, or they contradict the cycles
};

SideStrikes strikes_of(const phase::Searched& motion, const Phased& phased,
                       std::vector<phase::Mark> marks, Side side, std::vector<std::string>& notes) {
    if (marks.empty())
        return {side, 0, {}};
    Scatter scatter = scatter_of(std::move(marks));
    const std::size_t count = scatter.marks.size();
    if (scatter.deviation > most_scatter) {
        notes.push_back(not_used(
            count, side,
            format_text("they contradict the cycles, in which they scatter by {:.0f} %, above "
                        "{:.0f} %",
                        100 * scatter.deviation, 100 * most_scatter)));
        return {side, 0, {}};
    }
    std::erase_if(scatter.marks, [&](const phase::Mark& mark) {
        return std::abs(mark.phase - scatter.mean) > one_place;
    });
    SideStrikes strikes{side, scatter.marks.size(), {}};
    if (strikes.stated < count)
        notes.push_back(not_used(
            count - strikes.stated, side,
            format_text("the other {} are at another place of the cycle", strikes.stated)));
    for (const stltsa_event& event : events_at(motion, scatter.marks, phased))
        strikes.frames.push_back(event.frame);
    std::ranges::sort(strikes.frames);
    return strikes;
}

/// The side with which the cycles of a label begin.
Side present_side(const Decomposed& decomposed, std::int64_t label) {
    for (const stltsa_part& cycle : decomposed.cycles)
        if (cycle.label == label)
            return decomposed.named_side(cycle.side);
    return Side::neither;
}

} // namespace

FoundStrikes find_strikes(std::span<const clip::FootStrike> stated, const Decomposed& decomposed) {
    const auto phased = phase_of(decomposed);
    FoundStrikes found;
    bool in_motion = false;
    for (const PhasedMotion& motion : phased->motions) {
        if (!motion.phases.cyclic)
            continue;
        const std::size_t noted = found.notes.size();
        const phase::Searched where = searched(*phased, motion);
        const auto marks = [&](Side side) { return marks_in(where, *phased, stated, side); };
        const auto of = [&](std::vector<phase::Mark> some, Side side) {
            return strikes_of(where, *phased, std::move(some), side, found.notes);
        };
        SideStrikes begins = of(marks(Side::left), Side::left);
        SideStrikes middles = of(marks(Side::right), Side::right);
        const auto value = [](const SideStrikes& strikes) {
            return std::min<std::size_t>(strikes.stated, 2);
        };
        if (value(middles) > value(begins) ||
            (value(middles) == value(begins) &&
             present_side(decomposed, motion.label) == Side::right))
            std::swap(begins, middles);
        if (begins.frames.empty()) {
            auto feet = by_foot(marks(Side::neither));
            begins = of(std::move(feet[0]), Side::neither);
            middles = of(std::move(feet[1]), Side::neither);
            if (begins.frames.empty())
                std::swap(begins, middles);
        }
        in_motion = in_motion || !begins.frames.empty() || found.notes.size() > noted;
        if (!begins.frames.empty())
            found.motions.push_back({motion.label, begins.side, std::move(begins.frames),
                                     std::move(middles.frames), begins.stated, middles.stated});
    }
    if (!in_motion && !phased->motions.empty() && phased->motions.front().phases.cyclic)
        found.notes.push_back(
            format_text("foot strikes of the file that are not used: all {}; none lies in a cycle",
                        stated.size()));
    return found;
}

void note_strikes(const FoundStrikes& strikes, const motion::Recording& found,
                  std::vector<std::string>& notes) {
    std::ranges::copy(strikes.notes, std::back_inserter(notes));
    for (const MotionStrikes& motion : strikes.motions) {
        std::size_t begun = 0, others = 0;
        bool only = true;
        for (const motion::Cycle& cycle : found.cycles)
            if (found.segments[static_cast<std::size_t>(cycle.segment)].label == motion.label)
                ++(cycle.at_strikes ? begun : others);
            else
                only = false;
        if (begun == 0) {
            notes.push_back(not_used(motion.stated_begins, motion.side,
                                     "no whole cycle lies between two of them"));
            continue;
        }
        std::string text = "0 % of each cycle";
        if (!only)
            text += " of motion " + letters_of(motion.label);
        text += format_text(
            " is at a{} foot strike, as the events of the file say ({} {}",
            motion.side == Side::neither ? "" : format_text(" {}", side_text(motion.side)),
            motion.stated_begins, side_text(motion.side));
        if (!motion.middles.empty())
            text += format_text(", {} {}", motion.stated_middles, side_text(opposite(motion.side)));
        text += ")";
        if (motion.stated_begins < motion.begins.size())
            text += "; in cycles without such an event, where the motion is the same";
        if (others > 0)
            text += format_text("; {} of the {} cycles begin elsewhere, because no whole one lies "
                                "between two strikes",
                                others, begun + others);
        notes.push_back(text);
    }
}

} // namespace stltsa::results
