// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "reports/report.hpp"
#include "reports/table.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"
#include "terminal/width.hpp"

namespace tool {
namespace {

struct Estimate {
    std::int64_t dimension = 0; ///< 0: cannot tell
    std::string reason;         ///< why not
};

Estimate estimate_of(const stltsa::Info& info, std::int32_t key, std::int32_t reason) {
    return {info.integer(key), info.text(reason)};
}

Estimate local_pca_of(const stltsa::Info& info) {
    return estimate_of(info, STLTSA_INFO_LOCAL_PCA, STLTSA_INFO_LOCAL_PCA_REASON);
}

Estimate eigengap_of(const stltsa::Info& info) {
    return estimate_of(info, STLTSA_INFO_EIGENGAP, STLTSA_INFO_EIGENGAP_REASON);
}

constexpr std::size_t most_values = 10;
constexpr std::size_t bar_width = 40;

std::string estimate_text(const Estimate& estimate) {
    return estimate.dimension == 0 ? "undetermined" : std::to_string(estimate.dimension);
}

std::string reason_text(const Estimate& estimate) {
    return estimate.reason.empty() ? "" : fmt::format("  {}\n", estimate.reason);
}

/// The first values, with 0 in place of NaN.
std::vector<double> shown_values(std::vector<double> values) {
    values.resize(std::min(values.size(), most_values));
    std::ranges::replace_if(
        values, [](double value) { return !std::isfinite(value); }, 0.0);
    return values;
}

/// A table of numbers with bars; empty without numbers.
std::string spectrum(const std::vector<double>& values, const char* index, const char* name,
                     double unit) {
    using enum Align;
    Table table({right, right, left});
    table.add({index, name, ""});
    for (std::size_t i = 0; i < values.size(); ++i)
        table.add({std::to_string(i + 1), fmt::format("{:.4f}", values[i]),
                   bar(values[i] / unit, bar_width)});
    return values.empty() ? "" : table.text();
}

std::string local_pca_text(const stltsa::Info& info) {
    return fmt::format("\nLocal PCA: directions that explain {:g} % of a neighborhood's variance\n",
                       100 * info.real(STLTSA_INFO_VARIANCE)) +
           reason_text(local_pca_of(info)) +
           spectrum(shown_values(info.reals(STLTSA_INFO_LOCAL_VARIANCE)), "direction",
                    "share of variance", 1.0);
}

std::string eigengap_text(const stltsa::Info& info) {
    const std::vector<double> values = shown_values(info.reals(STLTSA_INFO_EIGENVALUE));
    const double largest = values.empty() ? 0 : std::ranges::max(values);
    const std::int64_t tangents = info.integer(STLTSA_INFO_DIMENSION);
    const std::string rule = fmt::format(
        "Eigengap: number of eigenvalues of B / k, zero included, before the first gap above {:g}. "
        "With tangent dimension {} the first {} are small by construction, so the estimate depends "
        "on --dimension.",
        info.real(STLTSA_INFO_EIGENGAP_THRESHOLD), tangents, tangents + 1);
    return '\n' + wrapped(rule, terminal_columns(STDOUT_FILENO)) + '\n' +
           reason_text(eigengap_of(info)) +
           spectrum(values, "index", "eigenvalue", std::max(largest, 1e-300));
}

} // namespace

std::string dimension_report(const stltsa::Model& result, const std::string& title) {
    const stltsa::Info info = result.info();
    Facts facts;
    facts.add("samples", samples_text(info));
    facts.add("features", features_text(info));
    facts.add("neighbors", neighbors_text(info));
    return bold(fmt::format("{}: intrinsic dimension {} (local PCA), {} (eigengap)", title,
                            estimate_text(local_pca_of(info)), estimate_text(eigengap_of(info)))) +
           "\n\n" + facts.text() + local_pca_text(info) + eigengap_text(info);
}

} // namespace tool
