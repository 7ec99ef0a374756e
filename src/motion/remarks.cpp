// SPDX-License-Identifier: BSD-3-Clause
#include "motion/remarks.hpp"

#include <cmath>

#include "ltsa/warnings.hpp"
#include "motion/curve/drift.hpp"
#include "motion/period.hpp"

namespace stltsa::motion {
namespace {

/// Shorter motions cannot confirm a period: 1.5 typical cycles of 1.2 s.
constexpr double least_motion_s = 1.8;
/// The share of drift is near 0 for poses without their path through space, which return to where
/// they were, and near 1 for a body that walks through space.
constexpr double much_drift = 0.5;

} // namespace

double break_time(const Embedding& embedding, const ltsa::Model& model, double fps,
                  double first_s) {
    const std::int64_t cut = ltsa::first_cut(model);
    return cut < 0 ? no_time : first_s + static_cast<double>(embedding.span.first + cut) / fps;
}

Warning parts_warning(const ltsa::Model& model, double break_s) {
    return ltsa::parts_warning(model, std::isnan(break_s) ? "" : format_text("{:.2f} s", break_s),
                               break_s);
}

std::string disconnected(const ltsa::Model& model, double break_s) {
    return format_text("no continuous curve: the neighborhood graph splits into {} parts{} (is "
                       "there a cut in the clip?)",
                       model.components.size(),
                       std::isnan(break_s) ? "" : format_text(" at {:.2f} s", break_s));
}

std::string no_period(const Activity& activity, double fps, const DecomposeOptions& options) {
    const double longest = longest_lag_s(activity.samples(), fps, options.longest_period);
    const double duration = static_cast<double>(activity.samples()) / fps;
    if (!(longest > options.shortest_period))
        return format_text("no period: the motion lasts {:.2f} s, which is too short for a period "
                           "of {:.2f} s or more",
                           duration, options.shortest_period);
    return format_text("no period: the motion lasts {:.2f} s and does not repeat at any lag from "
                       "{:.2f} s to {:.2f} s",
                       duration, options.shortest_period, longest);
}

void warn_about_motions(double fps, double first_s, Decomposition& result) {
    const bool cyclic = !result.cycles.empty();
    std::vector<Unit> actions;
    for (const Unit& unit : result.units)
        if (unit.kind == UnitKind::action &&
            (cyclic || unit.end - unit.begin >= least_motion_s * fps))
            actions.push_back(unit);
    if (!cyclic && actions.size() < 2)
        return;
    for (const Unit& unit : actions) {
        const double begin = first_s + unit.begin / fps;
        const double end = first_s + unit.end / fps;
        result.warnings.push_back(
            {WarningCode::separate_motion,
             format_text("the clip contains {} motion from {:.2f} s to {:.2f} s: split the clip "
                         "there to see whether it has cycles",
                         cyclic ? "another" : "a separate", begin, end),
             begin, end});
    }
}

void report_obstacles(ConstMatrixView samples, const DecomposeOptions& options,
                      Decomposition& result) {
    std::string text;
    if (!options.jump.empty())
        text = format_text("the pose jumps at {}: split the clip there, or repair the frame",
                           options.jump);
    else if (const double share = drift_share(samples);
             options.in_space && !result.reason.empty() && share > much_drift)
        text = format_text(
            "{:.0f} % of the variance is a linear drift, which hides any repetition: subtract the "
            "body's position, or set option features to points (markers, three columns each) or, "
            "if the clip has a skeleton, to positions",
            100 * share);
    if (text.empty())
        return;
    if (result.reason.empty())
        result.warnings.push_back({WarningCode::jump, text, options.jump_s, options.jump_s});
    else
        result.reason += "; " + text;
}

} // namespace stltsa::motion
