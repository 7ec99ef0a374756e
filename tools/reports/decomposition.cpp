// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <span>

#include <fmt/format.h>
#include <unistd.h>

#include "arguments/option_flags.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"
#include "terminal/width.hpp"

namespace tool {
namespace {

std::string seconds(double value) {
    return fmt::format("{:.3f}", value);
}

/// Begin, "-" and end in frames; the same in seconds; length.
template <class Row>
std::vector<std::string> interval_cells(const Row& interval) {
    return {std::to_string(interval.begin),
            "-",
            std::to_string(interval.end),
            seconds(interval.begin_s),
            "-",
            seconds(interval.end_s),
            seconds(interval.end_s - interval.begin_s)};
}

template <class Row>
void add_row(Table& table, std::vector<std::string> start, const Row& interval,
             const std::string& remark) {
    for (std::string& cell : interval_cells(interval))
        start.push_back(std::move(cell));
    start.push_back(remark);
    table.add(std::move(start));
}

Table interval_table(const std::string& name) {
    using enum Align;
    Table table({left, right, left, right, right, left, right, right, left});
    table.add({name, "frames", "", "", "seconds", "", "", "length (s)", ""});
    return table;
}

/// Longer lists are cut, with a line that says how many rows are left out.
constexpr std::int64_t most_rows = 60;

template <class Row>
std::span<const Row> shown(const std::vector<Row>& rows) {
    return std::span(rows).first(std::min<std::size_t>(rows.size(), most_rows));
}

std::string left_out(std::int64_t count, const char* what) {
    return count > most_rows ? fmt::format("  ... and {} more {}; all are in the JSON (--json)\n",
                                           count - most_rows, what)
                             : "";
}

/// How often the segment repeats, or what was seen, and what moves.
std::string segment_remark(const stltsa::Segment& segment) {
    std::string remark;
    if (segment.kind == STLTSA_SEGMENT_CYCLIC)
        remark = fmt::format("{} of {:.2f} s", counted(segment.count, "cycle"), segment.period_s);
    else if (segment.kind == STLTSA_SEGMENT_REPETITIONS)
        remark = fmt::format("{} times", segment.count);
    if (segment.candidate_period_s > 0)
        remark += fmt::format("{}perhaps every {:.2f} s", remark.empty() ? "" : ", ",
                              segment.candidate_period_s);
    if (segment.kind == STLTSA_SEGMENT_REST)
        return segment.reason; // empty, unless nothing was recorded
    remark += fmt::format("{}confidence {:.2f}", remark.empty() ? "" : ", ", segment.confidence);
    if (*segment.carried_by != nullptr)
        remark += fmt::format("; {}", *segment.carried_by);
    return remark;
}

/// Several segments, or one that repeats with pauses.
std::string segments_table(const stltsa::Decomposition& result) {
    using enum Align;
    Table table({left, left, right, left, right, right, left});
    table.add({"segment", "label", "seconds", "", "", "length (s)", ""});
    const std::vector<stltsa::Segment> segments = result.segments();
    for (const stltsa::Segment& segment : shown(segments))
        table.add({stltsa::segment_name(segment.kind), segment.letters, seconds(segment.begin_s),
                   "-", seconds(segment.end_s), seconds(segment.end_s - segment.begin_s),
                   segment_remark(segment)});
    return table.text() + left_out(std::ssize(segments), "segments") + '\n';
}

std::string units_table(const stltsa::Decomposition& result) {
    Table table = interval_table("unit");
    const std::vector<stltsa::Segment> segments = result.segments();
    const std::vector<stltsa::Unit> units = result.units();
    for (const stltsa::Unit& unit : shown(units)) {
        const stltsa::Segment& segment = segments.at(static_cast<std::size_t>(unit.segment));
        add_row(table, {stltsa::unit_name(unit.kind)}, unit,
                segment.kind == STLTSA_SEGMENT_REST ? segment.reason : "");
    }
    return table.text() + left_out(std::ssize(units), "units");
}

std::string cycles_table(const stltsa::Decomposition& result) {
    const std::vector<stltsa::Part> cycles = result.cycles();
    const std::int64_t count = std::ssize(cycles);
    if (count == 0)
        return "";
    const stltsa::Info info = result.info();
    Table table = interval_table("cycle");
    for (std::int64_t i = 0; i < std::min(count, most_rows); ++i) {
        std::string remark;
        if (info.integer(STLTSA_INFO_REPRESENTATIVE) == i)
            remark = "representative";
        if (count > 2 && info.integer(STLTSA_INFO_BEST) == i) // two are equally like each other
            remark += remark.empty() ? "best" : ", best";
        add_row(table, {std::to_string(i + 1)}, cycles[static_cast<std::size_t>(i)], remark);
    }
    return '\n' + table.text() + left_out(count, "cycles");
}

/// "left" or "right"; the number of a side whose name is unknown.
std::string side_text(std::int64_t side, std::int64_t name) {
    return side < 0                    ? "-"
           : name == STLTSA_SIDE_LEFT  ? "left"
           : name == STLTSA_SIDE_RIGHT ? "right"
                                       : fmt::format("side {}", side);
}

/// A row for each part whose travel is known.
std::vector<std::vector<std::string>> travel_rows(const std::vector<stltsa::Part>& parts,
                                                  const char* name) {
    const auto cell = [](double value) {
        return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string("-");
    };
    std::vector<std::vector<std::string>> rows;
    std::int64_t number = 0;
    for (const stltsa::Part& part : shown(parts)) {
        ++number;
        if (!std::isfinite(part.path_length))
            continue;
        const double turn = std::round(10 * part.turn_deg) / 10 + 0.0; // no -0.0
        rows.push_back(
            {fmt::format("{} {}", name, number),
             *part.side_name != '\0' ? part.side_name : side_text(part.side, STLTSA_SIDE_NONE),
             cell(part.path_length), cell(part.stride), cell(part.speed),
             std::isfinite(turn) ? fmt::format("{:.1f}", turn) : std::string("-")});
    }
    return rows;
}

/// The travel of each cycle and step, in the unit of the file; empty if it is unknown.
std::string travel_table(const stltsa::Decomposition& result) {
    using enum Align;
    const std::vector<stltsa::Part> cycles = result.cycles(), steps = result.steps();
    auto rows = travel_rows(cycles, "cycle");
    std::ranges::move(travel_rows(steps, "step"), std::back_inserter(rows));
    if (rows.empty())
        return "";
    Table table({left, left, right, right, right, right});
    table.add({"travel", "side", "path", "stride", "speed/s", "turn (deg)"});
    for (std::vector<std::string>& row : rows)
        table.add(std::move(row));
    return '\n' + table.text() + left_out(std::ssize(cycles), "cycles") +
           left_out(std::ssize(steps), "steps");
}

/// The motion of most cycles; empty: there are none.
std::optional<stltsa::Summary> main_motion(const stltsa::Decomposition& result) {
    std::optional<stltsa::Summary> found;
    std::int64_t most = 0;
    for (const stltsa::Summary& summary : result.summaries()) {
        const std::int64_t count =
            result.statistics(STLTSA_INFO_CYCLE, summary.label, -1, STLTSA_QUANTITY_TIME).count;
        if (count > most) {
            most = count;
            found = summary;
        }
    }
    return found;
}

/// Cadence and travel of the motion with most cycles.
void add_gait(const stltsa::Decomposition& result, Facts& facts) {
    const auto motion = main_motion(result);
    if (!motion)
        return;
    const stltsa::Statistics cycles =
        result.statistics(STLTSA_INFO_CYCLE, motion->label, -1, STLTSA_QUANTITY_TIME);
    const std::string which =
        result.info().count(STLTSA_INFO_SUMMARY) > 1 ? fmt::format(" of {}", motion->letters) : "";
    facts.add("cycle time" + which, fmt::format("{} s, SD {} s ({:.1f} %)", seconds(cycles.mean),
                                                seconds(cycles.sd), 100 * cycles.cv));
    if (motion->step_time_s.count > 0) {
        const auto side = [&](std::int64_t number) {
            return side_text(number, result.info().integer(STLTSA_INFO_SIDE, number));
        };
        facts.add("steps" + which,
                  fmt::format("{:.1f} a minute; {}: {} s, {}: {} s", motion->steps_per_min, side(0),
                              seconds(motion->step_time_side_0_s), side(1),
                              seconds(motion->step_time_side_1_s)));
    }
    const auto travel = [&](std::int32_t quantity) {
        return result.statistics(STLTSA_INFO_CYCLE, motion->label, -1, quantity);
    };
    if (const auto speed = travel(STLTSA_QUANTITY_SPEED); speed.count > 0) {
        const auto turn = travel(STLTSA_QUANTITY_TURN);
        facts.add("travel" + which,
                  fmt::format("stride {:.4g}, speed {:.4g} a second, in the file's unit{}",
                              travel(STLTSA_QUANTITY_STRIDE).mean, speed.mean,
                              turn.count == 0
                                  ? ""
                                  : fmt::format("; turn {:.1f} degrees a cycle",
                                                std::round(10 * turn.mean) / 10 + 0.0)));
    }
}

Facts facts_of(const stltsa::Decomposition& result) {
    const stltsa::Info info = result.info();
    Facts facts;
    if (const double period = info.real(STLTSA_INFO_PERIOD); period > 0)
        facts.add("period", fmt::format("{} s, lag quality {:.2f} (1: perfect repetition)",
                                        seconds(period), info.real(STLTSA_INFO_LAG_QUALITY)));
    const std::int64_t coordinate = info.integer(STLTSA_INFO_COORDINATE); // 0: nothing was fitted
    if (coordinate > 0)
        facts.add("curve", fmt::format("coordinate {} of tangent dimension {}, cyclicity {:.2f} "
                                       "(1: perfect oscillation)",
                                       coordinate, info.integer(STLTSA_INFO_DIMENSION),
                                       info.real(STLTSA_INFO_CYCLICITY)));
    add_gait(result, facts);
    if (coordinate > 0)
        facts.add("neighbors", fmt::format("k = {} and w = {} samples, of which a cycle has 24",
                                           info.integer(STLTSA_INFO_NEIGHBORS),
                                           info.integer(STLTSA_INFO_WINDOW)));
    facts.add("samples", samples_text(info));
    facts.add("features", features_text(info));
    return facts;
}

/// "3 cycles, period 1.10 s", or the reason why there are none.
std::string decomposition_summary(const stltsa::Decomposition& result) {
    const std::int64_t repetitions = result.info().count(STLTSA_INFO_REPETITION);
    std::string repeated =
        repetitions > 0 ? counted(repetitions, "repetition") + " with pauses" : "";
    const std::int64_t cycles = result.info().count(STLTSA_INFO_CYCLE);
    std::set<std::int64_t> cyclic;
    for (const stltsa::Segment& segment : result.segments())
        if (segment.kind == STLTSA_SEGMENT_CYCLIC)
            cyclic.insert(segment.label);
    if (cyclic.size() > 1) // each has a period of its own
        return fmt::format("{} of {} motions{}", counted(cycles, "cycle"), cyclic.size(),
                           repeated.empty() ? "" : "; " + repeated);
    if (cycles > 0)
        return fmt::format("{}, period {:.2f} s{}", counted(cycles, "cycle"),
                           result.info().real(STLTSA_INFO_PERIOD),
                           repeated.empty() ? "" : "; " + repeated);
    if (!repeated.empty())
        return repeated;
    const std::string reason = with_flags(result.reason());
    return reason.empty() ? "no cycle" : "no cycle; " + reason;
}

} // namespace

std::string decomposition_report(const stltsa::Decomposition& result, const std::string& title) {
    const stltsa::Info info = result.info();
    const std::string first =
        wrapped(title + ": " + decomposition_summary(result), terminal_columns(STDOUT_FILENO));
    return bold(first) + "\n\n" + segments_table(result) + units_table(result) +
           cycles_table(result) + travel_table(result) + '\n' + facts_of(result).text() +
           listed("note:", info.texts(STLTSA_INFO_NOTE)) +
           listed("warning:", texts_of(result.warnings()));
}

} // namespace tool
