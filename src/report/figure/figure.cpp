// SPDX-License-Identifier: BSD-3-Clause
#include "report/figure/figure.hpp"

#include <algorithm>

#include "base/names.hpp"
#include "base/progress.hpp"
#include "base/text.hpp"
#include "report/curve_rows.hpp"
#include "report/figure/panels.hpp"
#include "results/mirror_image.hpp"
#include "results/phased.hpp"

namespace stltsa::report {
namespace {

// One unit is a quarter of a millimeter when the figure is printed 180 mm wide.
constexpr double page_width = 720, left = 54, right = page_width - 14;

/// What repeats, or why nothing does.
std::string summary_of(const results::Decomposed& found) {
    std::string text;
    for (const stltsa_summary& motion : found.summaries) {
        const bool cyclic = std::ranges::any_of(found.segments, [&](const stltsa_segment& segment) {
            return segment.label == motion.label && segment.kind == STLTSA_SEGMENT_CYCLIC;
        });
        if (!text.empty())
            text += "; ";
        if (found.summaries.size() > 1)
            text += std::string(motion.letters) + ": ";
        text +=
            format_text("{} of {:.3f} s", counted(motion.count, cyclic ? "cycle" : "repetition"),
                        motion.cycle_time_s.mean);
        if (motion.count > 1)
            text += format_text(", standard deviation {:.3f} s", motion.cycle_time_s.sd);
    }
    return !text.empty() ? text : "no cycle" + (found.reason.empty() ? "" : "; " + found.reason);
}

/// Sets the samples that one curve connects to the middle of the representative cycle. Another
/// curve, of its segment or of the next, has other coordinates.
void find_shown(Figure& figure) {
    if (figure.found.representative < 0)
        return;
    const auto& cycle = figure.found.cycles[static_cast<std::size_t>(figure.found.representative)];
    const auto& segment = figure.found.segments[static_cast<std::size_t>(cycle.segment)];
    const auto known = [&](std::int64_t sample) {
        return sample >= 0 && sample < figure.rows.rows() && !std::isnan(figure.rows(sample, 0)) &&
               figure.frame_of(sample) >= segment.begin && figure.frame_of(sample) <= segment.end;
    };
    figure.begin = figure.end =
        static_cast<std::int64_t>(figure.sample_of((cycle.begin + cycle.end) / 2));
    while (known(figure.begin - 1))
        --figure.begin;
    while (known(figure.end))
        ++figure.end;
}

/// The colors of labels and of kinds of units, each once. Returns the y of the last row.
double draw_legend(Svg& svg, const Figure& figure, double y) {
    std::vector<std::pair<std::string, const char*>> entries;
    const auto add = [&](const std::string& name, const char* color) {
        if (std::ranges::find(entries, name, &std::pair<std::string, const char*>::first) ==
            entries.end())
            entries.emplace_back(name, color);
    };
    for (const stltsa_segment& segment : figure.found.segments)
        if (figure.several)
            add(segment.label < 0 ? "rest" : "motion " + letters_of(segment.label),
                label_color(segment.label));
    for (const stltsa_unit& unit : figure.found.units)
        add(std::string(name_of(unit_kinds, unit.kind)), unit_color(unit.kind));
    double x = left;
    for (const auto& [name, color] : entries) {
        const double taken = 30 + text_width(name, font);
        if (x + taken > right && x > left) {
            x = left;
            y += 16;
        }
        svg.rect({x, y - 9, 10, 10}, fill("key", color));
        svg.text({x + 14, y}, "start", name, fill("key-text", ink));
        x += taken;
    }
    return y;
}

} // namespace

std::string figure(const clip::Clip& clip, const results::Decomposed& found,
                   const std::string& title) {
    results::check_same_clip(clip, *found.rows);
    report_progress(Stage::write, 0);
    constexpr std::size_t most_cycles = 40;
    Figure drawn{found, found.rows->clip, curve_rows(found, 1)};
    find_shown(drawn);
    if (found.cycles.size() > 2 && found.representative >= 0) // of two, none is typical
        drawn.chosen = &found.cycles[static_cast<std::size_t>(found.representative)];
    drawn.dense = found.cycles.size() > most_cycles;
    const auto rests =
        std::ranges::count(found.segments, STLTSA_SEGMENT_REST, &stltsa_segment::kind);
    drawn.several = std::ssize(found.segments) - rests > 1;

    Svg svg;
    double y = 6;
    const auto write = [&](const std::string& text, double size, const char* color,
                           const char* weight) {
        for (const std::string& line : lines_of(text, size, right - left))
            svg.text({left, y += 1.35 * size}, "start", line,
                     fill("told", color, 1,
                          format_text(" font-size=\"{}\" font-weight=\"{}\"", size, weight)));
    };
    write(title, 15, ink, "bold");
    write(summary_of(found), 12, ink, "normal");
    std::optional<SideView> body;
    if (clip.skeleton && found.source.samples.up != clip::Axis::none)
        body.emplace(clip, found.source.samples.up);
    const double height = body ? 370 : 240;
    draw_time(svg, drawn, body ? &*body : nullptr, {left, y + 12, right - left, height});
    y = draw_legend(svg, drawn, y + height + 30) + 18;
    if (drawn.begin < drawn.end) {
        constexpr double side = 270, beside = left + side + 72;
        draw_loop(svg, drawn, {left, y, side, side});
        draw_cycles(svg, drawn, {beside, y, right - beside, side});
        y += side + 28;
        const auto& cycle = found.cycles[static_cast<std::size_t>(found.representative)];
        const auto& segment = found.segments[static_cast<std::size_t>(cycle.segment)];
        std::string note = "The curve drifts slowly: the width of the loop shows drift as well as "
                           "differences between cycles.";
        if (drawn.several)
            note = format_text(
                "The loop of {}, {:.1f} to {:.1f} s; every cyclic segment has its own. {}",
                letters_of(segment.label), segment.begin_s, segment.end_s, note);
        write(note, small_font, faint_ink, "normal");
    }
    return svg.document(page_width, y + 14, title);
}

} // namespace stltsa::report
