// SPDX-License-Identifier: BSD-3-Clause
#include "reports/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/table.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

/// The largest number of parts in the table; JSON and CSV have all.
constexpr std::size_t most_parts = 16;

/// Characters of a name in the table.
constexpr std::size_t longest_name = 32;

constexpr const char* unknown = "-";

std::string mark(const stltsa::Estimate& of) {
    return of.significant != 0 ? " *" : "  ";
}

std::string percent(double share) {
    return with_sign(100 * share, 1);
}

std::string interval(double low, double high) {
    return std::isnan(low) ? unknown : fmt::format("{} to {}", percent(low), percent(high));
}

std::string number(double value) {
    return std::isnan(value) ? unknown : fmt::format("{:.3g}", value);
}

std::string name_of(const stltsa::ComparedPart& part) {
    const auto shown = [](const char* name) { return shortened(one_line(name), longest_name); };
    const std::string first = shown(part.first), second = shown(part.second);
    return first == second ? first : first + " - " + second;
}

struct Row {
    std::string name;
    stltsa::ComparedPart part;
};

/// Parts that move, those with the largest differences first.
std::vector<Row> rows_of(const stltsa::Comparison& comparison) {
    std::vector<Row> rows;
    for (const stltsa::ComparedPart& part : comparison.parts())
        if (part.amplitude.first > 0 || part.amplitude.second > 0)
            rows.push_back({name_of(part), part});
    std::ranges::stable_sort(rows, std::ranges::greater{},
                             [](const Row& row) { return row.part.rms_difference; });
    return rows;
}

std::string parts_table(const stltsa::Comparison& comparison) {
    using enum Align;
    const std::vector<Row> rows = rows_of(comparison);
    Table table({left, right, right, right, right, right, right, right});
    table.add({"", "later, %", "95 %", "amplitude", "change, %", "95 %", "rms", "by chance"});
    for (std::size_t i = 0; i < std::min(rows.size(), most_parts); ++i) {
        const auto& [name, part] = rows[i];
        const bool timed = !std::isnan(part.lag.difference);
        table.add({name, timed ? percent(part.lag.difference) + mark(part.lag) : unknown,
                   interval(part.lag.low, part.lag.high), number(part.amplitude.first),
                   std::isnan(part.amplitude_ratio.value)
                       ? unknown
                       : percent(part.amplitude_ratio.value - 1) + mark(part.amplitude),
                   interval(part.amplitude_ratio.low - 1, part.amplitude_ratio.high - 1),
                   number(part.rms_difference), number(part.rms_by_chance)});
    }
    const std::size_t more = rows.size() - std::min(rows.size(), most_parts);
    return table.text() + (more == 0 ? ""
                                     : fmt::format("  ... and {} more with smaller rms; --json and "
                                                   "-o FILE.csv have all\n",
                                                   more));
}

std::string alignment_text(const stltsa::Compared& cycles) {
    if (cycles.sides != 0)
        return "right half a cycle later, mirrored";
    std::string text = fmt::format("second shifted by {} % of the cycle", percent(cycles.shift));
    if (!std::isnan(cycles.shift_low))
        text += fmt::format(" ({})", interval(cycles.shift_low, cycles.shift_high));
    text += fmt::format("; correlation {:.3f}", cycles.likeness);
    if (!std::isnan(cycles.runner_up))
        text += fmt::format(", at the next best shift {:.2f}", cycles.runner_up);
    if (cycles.turn_deg != 0)
        text += fmt::format("; turned by {} degrees", with_sign(cycles.turn_deg, 1));
    return text;
}

std::string time_text(const stltsa::Compared& cycles) {
    const stltsa::Estimate& time = cycles.cycle_time_s;
    std::string text = fmt::format("{:.3f} s", time.first);
    if (cycles.sides != 0)
        return text;
    text += fmt::format(" and {:.3f} s, {} s", time.second, with_sign(time.difference, 3));
    if (!std::isnan(time.low))
        text += fmt::format(" (95 %: {} to {}){}", with_sign(time.low, 3), with_sign(time.high, 3),
                            mark(time));
    return text;
}

void add_left_out(Facts& facts, const char* name, const stltsa::ComparedMotion& motion) {
    std::vector<std::string> names;
    for (const char* const* left_out = motion.left_out; *left_out != nullptr; ++left_out)
        names.emplace_back(*left_out);
    if (!names.empty())
        facts.add(name, fmt::format("{}", fmt::join(names, ", ")));
}

const char* const columns =
    "level,part,second_part,axis,rms,rms_by_chance,correlation,lag,lag_sd_first,lag_sd_second,"
    "lag_error,lag_low,lag_high,lag_significant,lag_s,amplitude_first,amplitude_sd_first,"
    "amplitude_second,amplitude_sd_second,amplitude_difference,amplitude_error,amplitude_low,"
    "amplitude_high,amplitude_significant,ratio,ratio_low,ratio_high,mean_first,mean_sd_first,"
    "mean_second,mean_sd_second,mean_difference,mean_error,mean_low,mean_high,mean_significant\n";

/// A number, or an empty cell if it is not known.
std::string cell(double value) {
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string significant_cell(const stltsa::Estimate& of) {
    return std::isnan(of.low) ? "" : fmt::format("{}", of.significant);
}

std::string values_cells(const stltsa::Estimate& of) {
    return fmt::format("{},{},{},{},{},{},{},{},{}", cell(of.first), cell(of.first_sd),
                       cell(of.second), cell(of.second_sd), cell(of.difference),
                       cell(of.standard_error), cell(of.low), cell(of.high), significant_cell(of));
}

std::string csv_row(const char* level, const stltsa::ComparedPart& of) {
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", level,
                       csv_cell(of.first), csv_cell(of.second), of.axis, cell(of.rms_difference),
                       cell(of.rms_by_chance), cell(of.correlation), cell(of.lag.difference),
                       cell(of.lag.first_sd), cell(of.lag.second_sd), cell(of.lag.standard_error),
                       cell(of.lag.low), cell(of.lag.high), significant_cell(of.lag),
                       cell(of.lag_s.value), values_cells(of.amplitude),
                       cell(of.amplitude_ratio.value), cell(of.amplitude_ratio.low),
                       cell(of.amplitude_ratio.high), values_cells(of.mean));
}

} // namespace

std::string comparison_report(const stltsa::Comparison& comparison, const std::string& first,
                              const std::string& second) {
    const stltsa::Compared cycles = comparison.whole();
    const stltsa::ComparedMotion motions[] = {comparison.motion(0), comparison.motion(1)};
    Facts facts;
    const auto count = [](const stltsa::ComparedMotion& of) {
        return fmt::format("{} of {}", counted(of.cycles, "cycle"), of.letters);
    };
    if (cycles.sides != 0) {
        facts.add("clip", first + ", left and right");
        facts.add("cycles", count(motions[0]));
    } else {
        facts.add("first", fmt::format("{}: {}, {:.1f} a minute", first, count(motions[0]),
                                       motions[0].cycles_per_min));
        facts.add("second", fmt::format("{}: {}, {:.1f} a minute", second, count(motions[1]),
                                        motions[1].cycles_per_min));
    }
    facts.add("cycle time", time_text(cycles));
    facts.add("alignment", alignment_text(cycles));
    facts.add("significant",
              fmt::format("{} of {} differences in timing and amplitude (*); about {:.0f} would be "
                          "significant by chance alone",
                          cycles.significant, cycles.judged, cycles.expected_by_chance));
    add_left_out(facts, "first only", motions[0]);
    add_left_out(facts, "second only", motions[1]);
    const std::string warnings = listed("warning:", texts_of(comparison.warnings()));
    return facts.text() + '\n' + parts_table(comparison) +
           (warnings.empty() ? "" : '\n' + warnings);
}

std::string comparison_csv(const stltsa::Comparison& comparison) {
    std::string text = columns;
    const std::vector<stltsa::ComparedPart> channels = comparison.channels();
    auto channel = channels.begin(); // they come part by part
    for (const stltsa::ComparedPart& part : comparison.parts()) {
        text += csv_row("part", part);
        for (; channel != channels.end() && channel->part == part.part; ++channel)
            text += csv_row("channel", *channel);
    }
    return text;
}

} // namespace tool
