// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report.hpp"
#include "style.hpp"
#include "table.hpp"
#include "text.hpp"

namespace tool {
namespace {

std::string sentence(const Json& model, const std::string& title) {
    const std::size_t components = model["components"].size();
    return fmt::format("{}: a curve of {} through {}, {}", title,
                       counted(model["parameters"]["dimension"].get<std::size_t>(), "coordinate"),
                       counted(model["samples"]["count"].get<std::size_t>(), "sample"),
                       components == 1
                           ? "in one piece"
                           : fmt::format("in {} pieces that do not share coordinates", components));
}

std::string scientific(const Json& value) {
    return value.is_null() ? "-" : fmt::format("{:.3g}", value.get<double>());
}

std::string eigenvalues_text(const Json& values) {
    std::vector<std::string> texts;
    for (const Json& value : values)
        texts.push_back(scientific(value));
    return fmt::format("{}", fmt::join(texts, " "));
}

std::string components_table(const Json& components, bool colors) {
    using enum Align;
    Table table({right, right, right, right, right, right, left});
    table.add({"piece", "samples", "residual", "error", "gap", "thin", "eigenvalues"});
    for (std::size_t i = 0; i < components.size(); ++i) {
        const Json& part = components[i];
        table.add({std::to_string(i + 1), part["frames"].dump(), scientific(part["residual"]),
                   scientific(part["error_estimate_rad"]), scientific(part["gap"]),
                   part["rank_deficient_windows"].dump(), eigenvalues_text(part["eigenvalues"])});
    }
    return table.text(true, colors);
}

constexpr const char* legend =
    "  residual: of the eigenvectors, over k; error: estimated angle to the exact\n"
    "  curve in radians; gap: ratio of the next eigenvalue to the last one used, near 1\n"
    "  is ill-defined; thin: neighborhoods of fewer directions than coordinates\n";

} // namespace

std::string model_report(const Json& model, const std::string& title, bool colors) {
    Facts facts;
    facts.add("samples", samples_text(model));
    facts.add("features", features_text(model));
    facts.add("neighbors", neighbors_text(model));
    if (!model["period_s"].is_null())
        facts.add("period",
                  fmt::format("{:.3f} s, which k rests on", model["period_s"].get<double>()));
    facts.add("clock", fmt::format("{:.4f}: rank correlation of coordinate 1 with time",
                                   model["clock"].is_null() ? 0.0 : model["clock"].get<double>()));
    if (const auto repeated = model["repeated_frames"].get<std::size_t>(); repeated > 0)
        facts.add("repeated", counted(repeated, "sample") + " like the one before");
    return bold(sentence(model, title), colors) + "\n\n" + facts.text() + '\n' +
           components_table(model["components"], colors) + dim(legend, colors) +
           listed("warning:", model["warnings"]);
}

} // namespace tool
