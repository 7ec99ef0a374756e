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

/// The number of pairs in the table; the JSON has all pairs.
constexpr std::size_t most_pairs = 6;

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
    for (const stltsa::ComparedPart& found : comparison.channels())
        list.push_back(JsonObject(
            "left", found.first, "right", found.second, "axis", json_or_null(found.axis),
            "rms_difference", found.rms_difference, "rms_by_chance", found.rms_by_chance,
            "mean_difference", -found.mean.difference, "left_range", found.amplitude.first,
            "right_range", found.amplitude.second, "range_difference", -found.amplitude.difference,
            "phase_shift", found.lag.difference, "correlation", found.correlation, "difference",
            negative(difference, std::ssize(list))));
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
    std::vector<stltsa::ComparedPart> pairs = comparison.channels();
    std::ranges::stable_sort(pairs, std::greater(), &stltsa::ComparedPart::rms_difference);
    Table table({left, left, right, right, right, right, right});
    table.add({"left - right", "", "rms", "by chance", "mean", "range", "right later"});
    for (std::size_t i = 0; i < std::min(pairs.size(), most_pairs); ++i) {
        const stltsa::ComparedPart& found = pairs[i];
        table.add({found.first, found.axis, number(found.rms_difference),
                   number(found.rms_by_chance), with_sign(-found.mean.difference),
                   with_sign(-found.amplitude.difference), percent(found.lag.difference)});
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
            JsonObject("label", of.letters, "reason", json_or_null(of.reason), "pairs",
                       of.comparison ? pairs_json(*of.comparison) : Json(std::vector<Json>())));
    return list;
}

std::string sides_report(const std::vector<LabelSides>& all) {
    std::string text;
    for (const LabelSides& of : all) {
        const std::string label = all.size() > 1 ? " in " + of.letters : "";
        text += of.comparison
                    ? (label.empty() ? "" : of.letters + ":\n") + table_of(*of.comparison)
                    : listed("no comparison of left and right" + label + ":", {of.reason});
    }
    return text.empty() ? text : '\n' + text;
}

} // namespace tool
