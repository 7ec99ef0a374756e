// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

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
std::vector<std::string> interval_cells(const stltsa::Interval& interval) {
    return {std::to_string(interval.begin),
            "-",
            std::to_string(interval.end),
            seconds(interval.begin_s),
            "-",
            seconds(interval.end_s),
            seconds(interval.end_s - interval.begin_s)};
}

void add_row(Table& table, std::vector<std::string> start, const stltsa::Interval& interval,
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

std::string left_out(std::int64_t count, const char* what) {
    return count > most_rows ? fmt::format("  ... and {} more {}; all are in the JSON (--json)\n",
                                           count - most_rows, what)
                             : "";
}

/// How often the segment repeats, or what was seen, and what moves.
std::string segment_remark(const stltsa::Decomposition& result, std::int64_t index,
                           const stltsa::Segment& segment) {
    std::string remark;
    if (segment.kind == STLTSA_SEGMENT_CYCLIC)
        remark = fmt::format("{} of {:.2f} s", counted(segment.count, "cycle"), segment.period_s);
    else if (segment.kind == STLTSA_SEGMENT_REPETITIONS)
        remark = fmt::format("{} times", segment.count);
    if (segment.candidate_period_s > 0)
        remark += fmt::format("{}perhaps every {:.2f} s", remark.empty() ? "" : ", ",
                              segment.candidate_period_s);
    if (segment.kind == STLTSA_SEGMENT_REST)
        return result.segment_reason(index); // empty, unless nothing was recorded
    remark += fmt::format("{}confidence {:.2f}", remark.empty() ? "" : ", ", segment.confidence);
    if (const auto carriers = result.carriers(index); !carriers.empty())
        remark += "; " + carriers.front();
    return remark;
}

/// Several segments, or one that repeats with pauses.
std::string segments_table(const stltsa::Decomposition& result) {
    using enum Align;
    Table table({left, left, right, left, right, right, left});
    table.add({"segment", "label", "seconds", "", "", "length (s)", ""});
    const std::int64_t count = result.segment_count();
    for (std::int64_t i = 0; i < std::min(count, most_rows); ++i) {
        const stltsa::Segment segment = result.segment(i);
        table.add({stltsa::segment_name(segment.kind), label_text(segment.label),
                   seconds(segment.begin_s), "-", seconds(segment.end_s),
                   seconds(segment.end_s - segment.begin_s), segment_remark(result, i, segment)});
    }
    return table.text() + left_out(count, "segments") + '\n';
}

std::string units_table(const stltsa::Decomposition& result) {
    Table table = interval_table("unit");
    const std::int64_t count = result.unit_count();
    for (std::int64_t i = 0; i < std::min(count, most_rows); ++i) {
        const stltsa::Interval unit = result.unit(i);
        const bool rests = result.segment(unit.segment).kind == STLTSA_SEGMENT_REST;
        add_row(table, {stltsa::unit_name(unit.kind)}, unit,
                rests ? result.segment_reason(unit.segment) : "");
    }
    return table.text() + left_out(count, "units");
}

std::string cycles_table(const stltsa::Decomposition& result) {
    const std::int64_t count = result.cycle_count();
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
        add_row(table, {std::to_string(i + 1)}, result.cycle(i), remark);
    }
    return '\n' + table.text() + left_out(count, "cycles");
}

/// "left" or "right"; the number of a side whose name is unknown.
std::string side_text(const stltsa::Decomposition& result, std::int32_t side) {
    const std::int32_t name = result.side(side);
    return side < 0                    ? "-"
           : name == STLTSA_SIDE_LEFT  ? "left"
           : name == STLTSA_SIDE_RIGHT ? "right"
                                       : fmt::format("side {}", side);
}

/// A row for each part of the kind whose travel is known.
std::vector<std::vector<std::string>> travel_rows(const stltsa::Decomposition& result,
                                                  std::int32_t kind, const char* name) {
    const auto cell = [](double value) {
        return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string("-");
    };
    std::vector<std::vector<std::string>> rows;
    for (std::int64_t i = 0; i < std::min(result.part_count(kind), most_rows); ++i) {
        const stltsa::Travel travel = result.travel(kind, i);
        if (!std::isfinite(travel.way))
            continue;
        const std::int32_t side = result.part(kind, i).side;
        const double turn = std::round(10 * travel.turn) / 10 + 0.0; // no -0.0
        rows.push_back({fmt::format("{} {}", name, i + 1), side_text(result, side),
                        cell(travel.way), cell(travel.stride), cell(travel.speed),
                        std::isfinite(turn) ? fmt::format("{:.1f}", turn) : std::string("-")});
    }
    return rows;
}

/// The travel of each cycle and step, in the unit of the file; empty if it is unknown.
std::string travel_table(const stltsa::Decomposition& result) {
    using enum Align;
    auto rows = travel_rows(result, STLTSA_PART_CYCLE, "cycle");
    std::ranges::move(travel_rows(result, STLTSA_PART_STEP, "step"), std::back_inserter(rows));
    if (rows.empty())
        return "";
    Table table({left, left, right, right, right, right});
    table.add({"travel", "side", "way", "stride", "speed/s", "turn (deg)"});
    for (std::vector<std::string>& row : rows)
        table.add(std::move(row));
    return '\n' + table.text() + left_out(result.part_count(STLTSA_PART_CYCLE), "cycles") +
           left_out(result.part_count(STLTSA_PART_STEP), "steps");
}

/// The label of most cycles; empty: there are none.
std::optional<std::int32_t> main_label(const stltsa::Decomposition& result) {
    std::optional<std::int32_t> label;
    std::int64_t most = 0;
    for (const stltsa::Summary& summary : result.summaries()) {
        const std::int64_t count =
            result.statistics(STLTSA_PART_CYCLE, summary.label, -1, STLTSA_QUANTITY_TIME).count;
        if (count > most) {
            most = count;
            label = summary.label;
        }
    }
    return label;
}

/// Cadence and travel of the motion with most cycles.
void add_gait(const stltsa::Decomposition& result, Facts& facts) {
    const std::optional<std::int32_t> label = main_label(result);
    if (!label)
        return;
    const auto of = [&](std::int32_t kind, std::int32_t side, std::int32_t quantity) {
        return result.statistics(kind, *label, side, quantity);
    };
    const stltsa::Statistics cycles = of(STLTSA_PART_CYCLE, -1, STLTSA_QUANTITY_TIME);
    const std::string which =
        result.summary_count() > 1 ? fmt::format(" of {}", label_text(*label)) : "";
    facts.add("cycle time" + which, fmt::format("{} s, SD {} s ({:.1f} %)", seconds(cycles.mean),
                                                seconds(cycles.sd), 100 * cycles.cv));
    if (const auto steps = of(STLTSA_PART_STEP, -1, STLTSA_QUANTITY_TIME); steps.count > 0)
        facts.add("steps" + which,
                  fmt::format("{:.1f} a minute; {}: {} s, {}: {} s", 60 / steps.mean,
                              side_text(result, 0),
                              seconds(of(STLTSA_PART_STEP, 0, STLTSA_QUANTITY_TIME).mean),
                              side_text(result, 1),
                              seconds(of(STLTSA_PART_STEP, 1, STLTSA_QUANTITY_TIME).mean)));
    const auto travel = [&](std::int32_t quantity) { return of(STLTSA_PART_CYCLE, -1, quantity); };
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

} // namespace

std::string decomposition_summary(const stltsa::Decomposition& result) {
    const std::int64_t repetitions = result.part_count(STLTSA_PART_REPETITION);
    std::string repeated =
        repetitions > 0 ? counted(repetitions, "repetition") + " with pauses" : "";
    std::set<std::int32_t> cyclic;
    for (const stltsa::Segment& segment : result.segments())
        if (segment.kind == STLTSA_SEGMENT_CYCLIC)
            cyclic.insert(segment.label);
    if (cyclic.size() > 1) // each has a period of its own
        return fmt::format("{} of {} motions{}", counted(result.cycle_count(), "cycle"),
                           cyclic.size(), repeated.empty() ? "" : "; " + repeated);
    if (result.cycle_count() > 0)
        return fmt::format("{}, period {:.2f} s{}", counted(result.cycle_count(), "cycle"),
                           result.info().real(STLTSA_INFO_PERIOD),
                           repeated.empty() ? "" : "; " + repeated);
    if (!repeated.empty())
        return repeated;
    const std::string reason = with_flags(result.reason());
    return reason.empty() ? "no cycle" : "no cycle; " + reason;
}

std::string decomposition_report(const stltsa::Decomposition& result, const std::string& title) {
    const stltsa::Info info = result.info();
    const std::string first =
        wrapped(title + ": " + decomposition_summary(result), terminal_columns(STDOUT_FILENO));
    return bold(first) + "\n\n" + segments_table(result) + units_table(result) +
           cycles_table(result) + travel_table(result) + '\n' + facts_of(result).text() +
           listed("note:", info.texts(STLTSA_INFO_NOTE)) +
           listed("warning:", info.texts(STLTSA_INFO_WARNING));
}

} // namespace tool
