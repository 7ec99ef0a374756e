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

std::string columns_table(const stltsa::Info& denoising) {
    using enum Align;
    Table table({right, right, right, right, right, right}, 2);
    table.add({"", "robust std.", "threshold", "points", "their mean", "curve's degrees"});
    table.add({"coordinate", "deviation", "(gamma)", "moved", "distance", "of freedom"});
    const auto digits = [&](std::int32_t key, std::int64_t column) {
        return fmt::format("{:.4g}", denoising.real(key, column));
    };
    for (std::int64_t c = 0; c < denoising.count(STLTSA_INFO_GAMMA); ++c)
        table.add(
            {std::to_string(c + 1), digits(STLTSA_INFO_NOISE, c), digits(STLTSA_INFO_GAMMA, c),
             std::to_string(denoising.integer(STLTSA_INFO_MOVED, c)), digits(STLTSA_INFO_SHIFT, c),
             fmt::format("{:.1f}", denoising.real(STLTSA_INFO_DEGREES_OF_FREEDOM, c))});
    return table.text();
}

} // namespace

std::string knots_text(const stltsa::Info& denoising) {
    const double knot_rows = denoising.real(STLTSA_INFO_KNOT_ROWS);
    std::string text = fmt::format("every {:.3g} samples", knot_rows);
    if (const double fps = denoising.real(STLTSA_INFO_FPS); fps > 0)
        text += fmt::format(" ({:.3f} s)", knot_rows / fps);
    return text +
           (denoising.integer(STLTSA_INFO_ROBUST) != 0 ? ", robust fit" : ", plain least squares");
}

std::string denoising_summary(const stltsa::Denoising& denoising) {
    const stltsa::Info info = denoising.info();
    std::int64_t moved = 0;
    for (const std::int64_t of_column : info.integers(STLTSA_INFO_MOVED))
        moved += of_column;
    const std::int64_t points = info.count(STLTSA_INFO_MOVED) * info.integer(STLTSA_INFO_ROWS);
    double share = 0;
    for (const double of_column : info.reals(STLTSA_INFO_NOISE_SHARE))
        share = std::max(share, of_column);
    const std::string what =
        fmt::format("{} of {} moved towards a smooth curve", moved, counted(points, "point"));
    return info.integer(STLTSA_INFO_NOTHING_TO_CLEAN) != 0
               ? fmt::format("nothing to clean: the noise is {:.2g} % of the range ({})",
                             100 * share, what)
               : fmt::format("{}; the noise is {:.2g} % of the range", what, 100 * share);
}

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
           "\n\n" + columns_table(info) + '\n' + facts.text() +
           listed("warning:", info.texts(STLTSA_INFO_WARNING));
}

} // namespace tool
