// SPDX-License-Identifier: BSD-3-Clause
#include "reports/sides.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "reports/table.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

/// A channel of the left side and the same one of the right side.
struct Pair {
    std::string left, right, axis;
    std::int64_t index = 0;
    stltsa::ComparedPart found;
};

/// The number of pairs in the table; the JSON has all pairs.
constexpr std::size_t most_pairs = 6;

std::vector<Pair> pairs_of(const stltsa::Comparison& comparison) {
    std::vector<Pair> pairs;
    for (const stltsa::ComparedPart& of : comparison.channels())
        pairs.push_back({comparison.part_name(0, of.part), comparison.part_name(1, of.part),
                         comparison.channel_axis(std::ssize(pairs)), std::ssize(pairs), of});
    return pairs;
}

/// Left minus right, where the comparison has second minus first.
std::vector<double> negative(const stltsa::Matrix& matrix, std::int64_t column) {
    std::vector<double> values;
    for (std::int64_t s = 0; s < matrix.rows; ++s)
        values.push_back(-matrix(s, column));
    return values;
}

Json pairs_json(const stltsa::Comparison& comparison) {
    const stltsa::Matrix difference = comparison.difference();
    std::vector<Json> list;
    for (const auto& [left, right, axis, index, found] : pairs_of(comparison))
        list.push_back(JsonObject(
            "left", left, "right", right, "axis", json_or_null(axis), "rms_difference", found.rms,
            "rms_by_chance", found.chance, "mean_difference", -found.mean.difference, "left_range",
            found.amplitude.first, "right_range", found.amplitude.second, "range_difference",
            -found.amplitude.difference, "phase_shift", found.lag.difference, "correlation",
            found.correlation, "difference", negative(difference, index)));
    return list;
}

std::string percent(double share) {
    return std::isnan(share) ? "-" : with_sign(100 * share, 1) + " %";
}

std::string number(double value) {
    return std::isnan(value) ? "-" : fmt::format("{:.3g}", value);
}

std::string with_sign(double value) {
    return std::isnan(value) ? "-" : fmt::format("{:+.3g}", value);
}

std::string table_of(const stltsa::Comparison& comparison) {
    using enum Align;
    std::vector<Pair> pairs = pairs_of(comparison);
    std::ranges::stable_sort(pairs, std::greater(), [](const Pair& of) { return of.found.rms; });
    Table table({left, left, right, right, right, right, right});
    table.add({"left - right", "", "rms", "by chance", "mean", "range", "right later"});
    for (std::size_t i = 0; i < std::min(pairs.size(), most_pairs); ++i) {
        const auto& [left_name, right_name, axis, index, found] = pairs[i];
        table.add({left_name, axis, number(found.rms), number(found.chance),
                   with_sign(-found.mean.difference), with_sign(-found.amplitude.difference),
                   percent(found.lag.difference)});
    }
    const std::size_t more = pairs.size() - std::min(pairs.size(), most_pairs);
    return table.text() +
           (more == 0 ? ""
                      : fmt::format("  ... and {} more pairs with smaller differences; all are in "
                                    "the JSON (--json)\n",
                                    more));
}

} // namespace

Json sides_json(const std::vector<LabelSides>& all) {
    std::vector<Json> list;
    for (const LabelSides& of : all)
        list.push_back(
            JsonObject("label", label_text(of.label), "reason", json_or_null(of.reason), "pairs",
                       of.comparison ? pairs_json(*of.comparison) : Json(std::vector<Json>())));
    return list;
}

std::string sides_report(const std::vector<LabelSides>& all) {
    std::string text;
    for (const LabelSides& of : all) {
        const std::string label = all.size() > 1 ? " in " + label_text(of.label) : "";
        text += of.comparison
                    ? (label.empty() ? "" : label_text(of.label) + ":\n") + table_of(*of.comparison)
                    : listed("no comparison of left and right" + label + ":", {of.reason});
    }
    return text.empty() ? text : '\n' + text;
}

} // namespace tool
