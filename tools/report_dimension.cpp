// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "report.hpp"
#include "style.hpp"
#include "table.hpp"

namespace tool {
namespace {

constexpr std::size_t most_rows = 10;
constexpr std::size_t bar_width = 40;

std::string estimate_text(const Json& estimate) {
    return estimate["dimension"].is_null() ? "cannot tell" : estimate["dimension"].dump();
}

std::string headline(const Json& result, const std::string& title) {
    return fmt::format("{}: intrinsic dimension {} by local PCA, {} by the eigengap", title,
                       estimate_text(result["local_pca"]), estimate_text(result["eigengap"]));
}

/// Numbers with bars; an empty text for no numbers.
std::string spectrum(const Json& values, const char* index, const char* name, double unit,
                     bool colors) {
    using enum Align;
    Table table({right, right, left});
    table.add({index, name, ""});
    for (std::size_t i = 0; i < std::min(values.size(), most_rows); ++i) {
        const double value = values[i].is_null() ? 0 : values[i].get<double>();
        table.add(
            {std::to_string(i + 1), fmt::format("{:.4f}", value), bar(value / unit, bar_width)});
    }
    return values.empty() ? "" : table.text(true, colors);
}

std::string reason_text(const Json& estimate) {
    return estimate["reason"].is_null()
               ? ""
               : fmt::format("  {}\n", estimate["reason"].get<std::string>());
}

double largest(const Json& values) {
    double most = 1e-300;
    for (std::size_t i = 0; i < std::min(values.size(), most_rows); ++i)
        if (values[i].is_number())
            most = std::max(most, values[i].get<double>());
    return most;
}

} // namespace

std::string dimension_report(const Json& result, const std::string& title, bool colors) {
    const Json& pca = result["local_pca"];
    const Json& gap = result["eigengap"];
    Facts facts;
    facts.add("samples", samples_text(result));
    facts.add("features", features_text(result));
    facts.add("neighbors", neighbors_text(result));
    std::string text = bold(headline(result, title), colors) + "\n\n" + facts.text();
    text += fmt::format("\nLocal PCA: directions that hold {:g} % of a neighborhood's variance\n",
                        100 * pca["variance"].get<double>());
    text += reason_text(pca) + spectrum(pca["shares"], "direction", "share", 1.0, colors);
    text +=
        fmt::format("\nEigengap: eigenvalues up to the first gap above {:g}; the zero one\n"
                    "counts, and as many as the tangent dimension that B was built with, {}, are\n"
                    "small beside it by construction: the answer moves with that\n",
                    gap["threshold"].get<double>(), result["parameters"]["dimension"].dump());
    text += reason_text(gap) + spectrum(gap["eigenvalues"], "eigenvalue", "of B / k",
                                        largest(gap["eigenvalues"]), colors);
    return text;
}

} // namespace tool
