// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/report.hpp"
#include "reports/table.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

std::string sentence(const stltsa::Info& model, const std::string& title) {
    const std::int64_t components = model.count(STLTSA_INFO_COMPONENT);
    return fmt::format("{}: a curve of {} through {}, {}", title,
                       counted(model.integer(STLTSA_INFO_DIMENSION), "coordinate"),
                       counted(model.integer(STLTSA_INFO_ROWS), "sample"),
                       components == 1
                           ? "in one piece"
                           : fmt::format("in {} pieces with separate coordinates", components));
}

std::string scientific(double value) {
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : "-";
}

std::string components_table(const stltsa::Model& model) {
    using enum Align;
    const std::vector<stltsa::Component> components = model.components();
    const stltsa::Matrix eigenvalues = model.eigenvalues();
    Table table({right, right, right, right, right, right, left}, 2);
    table.add({"", "", "residual", "angle error", "eigengap", "rank-deficient", ""});
    table.add({"piece", "samples", "/ k", "(rad)", "ratio", "windows", "eigenvalues"});
    for (std::int64_t i = 0; i < eigenvalues.rows; ++i) {
        std::vector<std::string> values;
        for (const double value : eigenvalues.row(i))
            values.push_back(scientific(value));
        const stltsa::Component& of = components[static_cast<std::size_t>(i)];
        table.add({std::to_string(i + 1), std::to_string(of.frames), scientific(of.residual),
                   scientific(of.error_estimate_rad), scientific(of.gap),
                   std::to_string(of.rank_deficient_windows),
                   fmt::format("{}", fmt::join(values, " "))});
    }
    return table.text();
}

} // namespace

std::string model_report(const stltsa::Model& model, const std::string& title) {
    const stltsa::Info info = model.info();
    Facts facts;
    facts.add("samples", samples_text(info));
    facts.add("features", features_text(info));
    facts.add("neighbors", neighbors_text(info));
    if (const double period = info.real(STLTSA_INFO_PERIOD); period > 0)
        facts.add("period", fmt::format("{:.3f} s, from which k follows", period));
    const double correlation = info.real(STLTSA_INFO_TIME_CORRELATION);
    facts.add("time", fmt::format("rank correlation {:.4f} with coordinate 1",
                                  std::isfinite(correlation) ? correlation : 0));
    if (const std::int64_t repeated = info.integer(STLTSA_INFO_REPEATED); repeated > 0)
        facts.add("repeated", counted(repeated, "sample") + " equal to the previous sample");
    return bold(sentence(info, title)) + "\n\n" + facts.text() + '\n' + components_table(model) +
           listed("warning:", texts_of(model.warnings()));
}

} // namespace tool
