// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "option_flags.hpp"
#include "report.hpp"
#include "style.hpp"
#include "table.hpp"
#include "text.hpp"

namespace tool {
namespace {

std::string seconds(double value) {
    return fmt::format("{:.3f}", value);
}

/// begin, "-", end in frames; the same in seconds; length.
std::vector<std::string> interval_cells(const Json& interval) {
    const double begin = interval["begin_s"];
    const double end = interval["end_s"];
    return {interval["begin"].dump(), "-", interval["end"].dump(),
            seconds(begin),           "-", seconds(end),
            seconds(end - begin)};
}

void add_row(Table& table, std::vector<std::string> start, const Json& interval,
             const std::string& remark) {
    for (std::string& cell : interval_cells(interval))
        start.push_back(std::move(cell));
    start.push_back(remark);
    table.add(std::move(start));
}

Table interval_table(const std::string& name) {
    using enum Align;
    Table table({left, right, left, right, right, left, right, right, left});
    table.add({name, "frames", "", "", "seconds", "", "", "length", ""});
    return table;
}

std::string units_table(const Json& units, bool colors) {
    Table table = interval_table("unit");
    for (const Json& unit : units)
        add_row(table, {unit["kind"]}, unit, "");
    return table.text(true, colors);
}

bool is_cycle(const Json& chosen, std::size_t index) {
    return !chosen.is_null() && chosen["index"] == index;
}

std::string cycles_table(const Json& result, bool colors) {
    const Json& cycles = result["cycles"];
    if (cycles.empty())
        return "";
    Table table = interval_table("cycle");
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        std::string remark;
        if (is_cycle(result["representative_cycle"], i))
            remark = "representative";
        if (is_cycle(result["best_cycle"], i))
            remark += remark.empty() ? "best" : ", best";
        add_row(table, {std::to_string(i + 1)}, cycles[i], remark);
    }
    return '\n' + table.text(true, colors);
}

std::string dimension_text(const Json& dimension) {
    const auto estimate = [](const Json& value) {
        return value.is_null() ? std::string("cannot tell") : value.dump();
    };
    return fmt::format("{} by local PCA, {} by the eigengap", estimate(dimension["local_pca"]),
                       estimate(dimension["eigengap"]));
}

Facts facts_of(const Json& result) {
    const Json& embedding = result["embedding"];
    Facts facts;
    if (!result["period_s"].is_null())
        facts.add("period",
                  fmt::format("{} s, lag quality {:.2f} (1: perfect)", seconds(result["period_s"]),
                              result["lag_quality"].get<double>()));
    if (!embedding["coordinate"].is_null())
        facts.add("curve",
                  fmt::format("coordinate {} of tangent dimension {}, cyclicity {:.2f} "
                              "(1: perfect)",
                              embedding["coordinate"].dump(), embedding["tangent_dimension"].dump(),
                              embedding["cyclicity"].get<double>()));
    facts.add("neighbors", neighbors_text(result));
    facts.add("samples", samples_text(result));
    facts.add("features", features_text(result));
    if (!result["intrinsic_dimension"].is_null())
        facts.add("dimension", dimension_text(result["intrinsic_dimension"]));
    return facts;
}

} // namespace

std::string decomposition_summary(const Json& result) {
    const std::size_t cycles = result["cycles"].size();
    if (cycles == 0 && !result["reason"].is_null())
        return fmt::format("no cycle; {}", with_flags(result["reason"].get<std::string>()));
    if (cycles == 0)
        return "no cycle";
    return fmt::format("{}, period {:.2f} s", counted(cycles, "cycle"),
                       result["period_s"].get<double>());
}

std::string decomposition_report(const Json& result, const std::string& title, bool colors) {
    const std::string first = wrapped(title + ": " + decomposition_summary(result), 80);
    return bold(first, colors) + "\n\n" + units_table(result["units"], colors) +
           cycles_table(result, colors) + '\n' + facts_of(result).text() +
           listed("note:", result["clip"]["notes"]) + listed("warning:", result["warnings"]);
}

} // namespace tool
