// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "arguments/option_flags.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"

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

std::string units_table(const std::vector<stltsa::Interval>& units) {
    Table table = interval_table("unit");
    for (const stltsa::Interval& unit : units)
        add_row(table, {stltsa::unit_name(unit.kind)}, unit, "");
    return table.text();
}

std::string cycles_table(const stltsa::Decomposition& result) {
    if (result.cycle_count() == 0)
        return "";
    const stltsa::Info info = result.info();
    Table table = interval_table("cycle");
    for (std::int64_t i = 0; i < result.cycle_count(); ++i) {
        std::string remark;
        if (info.integer(STLTSA_INFO_REPRESENTATIVE) == i)
            remark = "representative";
        if (info.integer(STLTSA_INFO_BEST) == i)
            remark += remark.empty() ? "best" : ", best";
        add_row(table, {std::to_string(i + 1)}, result.cycle(i), remark);
    }
    return '\n' + table.text();
}

std::string dimension_text(const stltsa::Info& info) {
    const auto estimate = [&](std::int32_t key) {
        const std::int64_t value = info.integer(key);
        return value == 0 ? std::string("undetermined") : std::to_string(value);
    };
    return fmt::format("{} (local PCA), {} (eigengap)", estimate(STLTSA_INFO_LOCAL_PCA),
                       estimate(STLTSA_INFO_EIGENGAP));
}

Facts facts_of(const stltsa::Info& info) {
    Facts facts;
    if (const double period = info.real(STLTSA_INFO_PERIOD); period > 0)
        facts.add("period", fmt::format("{} s, lag quality {:.2f} (1: perfect repetition)",
                                        seconds(period), info.real(STLTSA_INFO_LAG_QUALITY)));
    if (const std::int64_t coordinate = info.integer(STLTSA_INFO_COORDINATE); coordinate > 0)
        facts.add("curve", fmt::format("coordinate {} of tangent dimension {}, cyclicity {:.2f} "
                                       "(1: perfect oscillation)",
                                       coordinate, info.integer(STLTSA_INFO_DIMENSION),
                                       info.real(STLTSA_INFO_CYCLICITY)));
    facts.add("neighbors", neighbors_text(info));
    facts.add("samples", samples_text(info));
    facts.add("features", features_text(info));
    if (info.count(STLTSA_INFO_LOCAL_PCA) > 0)
        facts.add("dimension", dimension_text(info));
    return facts;
}

} // namespace

std::string decomposition_summary(const stltsa::Decomposition& result) {
    if (result.cycle_count() > 0)
        return fmt::format("{}, period {:.2f} s", counted(result.cycle_count(), "cycle"),
                           result.info().real(STLTSA_INFO_PERIOD));
    const std::string reason = with_flags(result.reason());
    return reason.empty() ? "no cycle" : "no cycle; " + reason;
}

std::string decomposition_report(const stltsa::Decomposition& result, const std::string& title) {
    const stltsa::Info info = result.info();
    const std::string first = wrapped(title + ": " + decomposition_summary(result), 80);
    return bold(first) + "\n\n" + units_table(result.units()) + cycles_table(result) + '\n' +
           facts_of(info).text() + listed("note:", info.texts(STLTSA_INFO_NOTE)) +
           listed("warning:", info.texts(STLTSA_INFO_WARNING));
}

} // namespace tool
