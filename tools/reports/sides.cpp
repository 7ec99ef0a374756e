// SPDX-License-Identifier: BSD-3-Clause
#include "reports/sides.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "reports/table.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

/// The number of pairs in the table; the JSON has all pairs.
constexpr std::size_t most_pairs = 6;

/// Pairs with names and coordinates.
struct Named {
    std::string left, right, axis;
    std::int64_t index = 0;
    stltsa::SidePair pair;
};

std::vector<Named> named_pairs(const stltsa::Sides& sides, bool axes) {
    std::map<std::string, std::size_t> seen;
    std::vector<Named> all;
    for (std::int64_t i = 0; i < sides.count(); ++i) {
        const std::string left = sides.left_name(i);
        const std::size_t part = seen[left]++;
        const std::string axis = axes && part < 3 ? std::string(1, "xyz"[part]) : std::string();
        all.push_back({left, sides.right_name(i), axis, i, sides.pair(i)});
    }
    return all;
}

std::vector<double> column(const stltsa::Matrix& matrix, std::int64_t index) {
    std::vector<double> values;
    for (std::int64_t s = 0; s < matrix.rows; ++s)
        values.push_back(matrix(s, index));
    return values;
}

Json pairs_json(const stltsa::Sides& sides, bool axes) {
    const stltsa::Matrix difference = sides.difference();
    std::vector<Json> list;
    for (const auto& [left, right, axis, index, pair] : named_pairs(sides, axes))
        list.push_back(JsonObject(
            "left", left, "right", right, "axis", json_or_null(axis), "rms_difference", pair.rms,
            "rms_by_chance", pair.chance, "mean_difference", pair.mean, "left_range",
            pair.left_range, "right_range", pair.right_range, "range_difference",
            pair.left_range - pair.right_range, "phase_shift", pair.shift, "correlation",
            pair.correlation, "difference", column(difference, index)));
    return list;
}

std::string why_not(const LabelSides& of) {
    return of.sides ? of.sides->reason() : of.reason;
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

std::string table_of(const stltsa::Sides& sides, bool axes) {
    using enum Align;
    std::vector<Named> pairs = named_pairs(sides, axes);
    std::ranges::stable_sort(pairs, [](const Named& a, const Named& b) {
        return a.pair.rms > b.pair.rms || (std::isnan(b.pair.rms) && !std::isnan(a.pair.rms));
    });
    Table table({left, left, right, right, right, right, right});
    table.add({"left - right", "", "rms", "by chance", "mean", "range", "right later"});
    for (std::size_t i = 0; i < std::min(pairs.size(), most_pairs); ++i) {
        const auto& [name, other, axis, index, pair] = pairs[i];
        table.add({name, axis, number(pair.rms), number(pair.chance), with_sign(pair.mean),
                   with_sign(pair.left_range - pair.right_range), percent(pair.shift)});
    }
    const std::size_t more = pairs.size() - std::min(pairs.size(), most_pairs);
    return table.text() +
           (more == 0 ? ""
                      : fmt::format("  ... and {} more pairs with smaller differences; all are in "
                                    "the JSON (--json)\n",
                                    more));
}

} // namespace

Json sides_json(const std::vector<LabelSides>& all, bool axes) {
    std::vector<Json> list;
    for (const LabelSides& of : all)
        list.push_back(
            JsonObject("label", label_text(of.label), "reason", json_or_null(why_not(of)), "pairs",
                       of.sides ? pairs_json(*of.sides, axes) : Json(std::vector<Json>())));
    return list;
}

std::string sides_report(const std::vector<LabelSides>& all, bool axes) {
    std::string text;
    for (const LabelSides& of : all) {
        const std::string reason = why_not(of);
        const std::string label = all.size() > 1 ? " in " + label_text(of.label) : "";
        text += reason.empty() ? (label.empty() ? "" : label_text(of.label) + ":\n") +
                                     table_of(*of.sides, axes)
                               : listed("no comparison of left and right" + label + ":", {reason});
    }
    return text.empty() ? text : '\n' + text;
}

} // namespace tool
