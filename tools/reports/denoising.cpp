// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include "reports/report.hpp"
#include "reports/table.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"
#include "terminal/width.hpp"

namespace tool {
namespace {

std::string columns_table(const stltsa::Denoising& denoising) {
    using enum Align;
    Table table({right, right, right, right, right, right}, 2);
    table.add({"", "robust std.", "threshold", "points", "their mean", "curve's degrees"});
    table.add({"coordinate", "deviation", "(gamma)", "moved", "distance", "of freedom"});
    const auto digits = [](double value) { return fmt::format("{:.4g}", value); };
    std::int64_t number = 0;
    for (const stltsa::DenoisedColumn& of : denoising.columns())
        table.add({std::to_string(++number), digits(of.noise), digits(of.gamma),
                   std::to_string(of.moved), digits(of.shift),
                   fmt::format("{:.1f}", of.degrees_of_freedom)});
    return table.text();
}

/// "every 3.3 samples (0.110 s), robust fit"
std::string knots_text(const stltsa::Info& denoising) {
    const double knot_rows = denoising.real(STLTSA_INFO_KNOT_ROWS);
    std::string text = fmt::format("every {:.3g} samples", knot_rows);
    if (const double fps = denoising.real(STLTSA_INFO_FPS); fps > 0)
        text += fmt::format(" ({:.3f} s)", knot_rows / fps);
    return text +
           (denoising.integer(STLTSA_INFO_ROBUST) != 0 ? ", robust fit" : ", plain least squares");
}

/// "12 of 422 points moved towards a smooth curve"
std::string denoising_summary(const stltsa::Denoising& denoising) {
    const stltsa::Info info = denoising.info();
    std::int64_t moved = 0, points = 0;
    double share = 0;
    for (const stltsa::DenoisedColumn& of : denoising.columns()) {
        moved += of.moved;
        points += info.integer(STLTSA_INFO_ROWS);
        share = std::max(share, of.noise_share);
    }
    const std::string what =
        fmt::format("{} of {} moved towards a smooth curve", moved, counted(points, "point"));
    return info.integer(STLTSA_INFO_NOTHING_TO_CLEAN) != 0
               ? fmt::format("nothing to clean: the noise is {:.2g} % of the range ({})",
                             100 * share, what)
               : fmt::format("{}; the noise is {:.2g} % of the range", what, 100 * share);
}

} // namespace

std::string denoising_report(const stltsa::Denoising& denoising, const std::string& title) {
    const stltsa::Info info = denoising.info();
    Facts facts;
    facts.add("samples", samples_text(info));
    if (info.count(STLTSA_INFO_NEIGHBORS) > 0) {
        if (info.count(STLTSA_INFO_FORMAT) > 0)
            facts.add("features", features_text(info));
        facts.add("neighbors", neighbors_text(info));
    }
    if (const double period = info.real(STLTSA_INFO_PERIOD); period > 0)
        facts.add("period", fmt::format("{:.3f} s", period));
    facts.add("knots", knots_text(info));
    return bold(wrapped(title + ": " + denoising_summary(denoising),
                        terminal_columns(STDOUT_FILENO))) +
           "\n\n" + columns_table(denoising) + '\n' + facts.text() +
           listed("warning:", texts_of(denoising.warnings()));
}

} // namespace tool
