// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "report.hpp"
#include "style.hpp"
#include "table.hpp"
#include "text.hpp"

namespace tool {
namespace {

std::string columns_table(const Json& columns, bool colors) {
    using enum Align;
    Table table({right, right, right, right, right, right});
    table.add({"coordinate", "noise", "gamma", "shift", "moved", "freedom"});
    const auto digits = [](const Json& value) {
        return fmt::format("{:.4g}", value.get<double>());
    };
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const Json& column = columns[c];
        table.add({std::to_string(c + 1), digits(column["noise"]), digits(column["gamma"]),
                   digits(column["shift"]), column["moved"].dump(),
                   fmt::format("{:.1f}", column["freedom"].get<double>())});
    }
    return table.text(true, colors);
}

constexpr const char* legend =
    "  noise: robust standard deviation of the points about the fitted curve; gamma:\n"
    "  distance from it beyond which a point is moved; shift: mean distance of these\n"
    "  points, by which they are moved, the curve not being crossed; freedom:\n"
    "  effective degrees of freedom of the curve\n";

} // namespace

std::string knots_text(const Json& denoising) {
    const Json& parameters = denoising["parameters"];
    std::string text = fmt::format("every {:.3g} samples", parameters["knot_rows"].get<double>());
    if (!parameters["knot_s"].is_null())
        text += fmt::format(" ({:.3f} s)", parameters["knot_s"].get<double>());
    return text + (parameters["robust"].get<bool>() ? ", robust fit" : ", plain least squares");
}

std::string denoising_summary(const Json& denoising) {
    const Json& columns = denoising["columns"];
    std::size_t moved = 0;
    for (const Json& column : columns)
        moved += column["moved"].get<std::size_t>();
    const std::size_t points = columns.size() * denoising["samples"]["count"].get<std::size_t>();
    return fmt::format("{} of {} moved towards a smooth curve", moved, counted(points, "point"));
}

std::string denoising_report(const Json& result, const std::string& title, bool colors) {
    Facts facts;
    facts.add("samples", samples_text(result));
    if (!result["fit"].is_null()) {
        if (!result["clip"].is_null())
            facts.add("features", features_text(result));
        facts.add("neighbors",
                  neighbors_text({{"parameters", result["fit"]}, {"samples", result["samples"]}}));
    }
    if (!result["period_s"].is_null())
        facts.add("period", fmt::format("{:.3f} s", result["period_s"].get<double>()));
    facts.add("knots", knots_text(result));
    return bold(wrapped(title + ": " + denoising_summary(result), 80), colors) + "\n\n" +
           columns_table(result["columns"], colors) + dim(legend, colors) + '\n' + facts.text() +
           listed("warning:", result["warnings"]);
}

} // namespace tool
