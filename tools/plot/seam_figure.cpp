// SPDX-License-Identifier: BSD-3-Clause
#include "plot/seam_figure.hpp"

#include <algorithm>

#include <stltsa.hpp>

#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/stick_figure.hpp"
#include "plot/svg.hpp"
#include "plot/title.hpp"

namespace tool::plot {
namespace {

constexpr double width = 720;
constexpr double left = 20;
constexpr double right = width - 20;
constexpr double slot = (right - left) / static_cast<double>(strip_postures);
constexpr double posture_height = 92;
constexpr double small_font = 9.5;
constexpr double note_font = 10.5;

/// The frame of the clip that a loop shows at this one.
std::int64_t shown(const Strip& strip, std::int64_t frame, std::int64_t count) {
    return strip.wraps ? (frame % count + count) % count : frame;
}

/// The frames of a strip that exist in the clip; of a wrap, those beyond its end as well.
std::vector<std::int64_t> frames_of(const Strip& strip, std::int64_t count) {
    std::vector<std::int64_t> frames;
    for (std::int64_t i = 0; i < strip_postures; ++i) {
        const std::int64_t frame = strip.middle + (i - strip_postures / 2) * strip.step;
        if (strip.wraps || (frame >= 0 && frame < count))
            frames.push_back(frame);
    }
    return frames;
}

/// Figure units per file unit, such that the largest posture fits.
double scale_of(const SeamFigure& figure) {
    constexpr double air = 2;
    Rect largest;
    for (const Strip& strip : figure.strips)
        for (const std::int64_t frame : frames_of(strip, figure.bodies.frames())) {
            const Rect box =
                posture_box(figure.bodies, shown(strip, frame, figure.bodies.frames()));
            largest.width = std::max(largest.width, box.width);
            largest.height = std::max(largest.height, box.height);
        }
    constexpr double tiny = 1e-300;
    return std::min(posture_height / std::max(largest.height, tiny),
                    (slot - air) / std::max(largest.width, tiny));
}

double place(const Strip& strip, double frame) {
    return 0.5 * (left + right) +
           slot * (frame - static_cast<double>(strip.middle)) / static_cast<double>(strip.step);
}

/// The blended frames, and the line between the last frame of one piece and the first of the next.
void draw_seam(Svg& svg, const Strip& strip, double top, double ground) {
    const double seam = static_cast<double>(strip.middle) - 0.5;
    const auto blended = static_cast<double>(strip.crossfade);
    const double from = std::max(left, place(strip, seam - blended));
    const double to = std::min(right, place(strip, seam + blended));
    svg.rect({from, top, to - from, ground - top},
             {{"class", "crossfade"}, {"fill", unit_colors(STLTSA_UNIT_CYCLIC).band}});
    svg.line({place(strip, seam), top}, {place(strip, seam), ground},
             {{"class", "seam"},
              {"stroke", unit_colors(STLTSA_UNIT_FINAL).line},
              {"stroke-width", 1.2},
              {"stroke-dasharray", "4 3"}});
}

double draw_note(Svg& svg, const std::string& note, double y) {
    for (const std::string& line : lines_of(note, note_font, right - left))
        svg.text({left, y += 14}, Anchor::start, line, {{"font-size", note_font}});
    return y;
}

/// Returns the y at which the strip ends.
double draw_strip(Svg& svg, const SeamFigure& figure, const Strip& strip, double scale, double y) {
    svg.text({left, y += 20}, Anchor::start, shortened(strip.heading, 13, right - left),
             {{"font-weight", "bold"}});
    y = draw_note(svg, strip.note, y);
    const double top = y + 8;
    const double ground = top + posture_height + 6;
    if (strip.crossfade >= 0)
        draw_seam(svg, strip, top, ground);
    svg.line({left, ground}, {right, ground}, {{"stroke", hairline}, {"stroke-width", 0.8}});
    for (const std::int64_t frame : frames_of(strip, figure.bodies.frames())) {
        const double x = place(strip, static_cast<double>(frame));
        const std::int64_t posture = shown(strip, frame, figure.bodies.frames());
        draw_stick_figure(svg, figure.bodies, posture, {x, ground}, scale);
        svg.text({x, ground + 14}, Anchor::middle, std::to_string(posture),
                 {{"class", "number"}, {"font-size", small_font}});
    }
    return ground + 20;
}

} // namespace

std::string seam_figure_svg(const SeamFigure& figure) {
    Svg svg;
    double y = draw_title(svg, figure.title, figure.summary, left, right);
    const double scale = scale_of(figure);
    for (const Strip& strip : figure.strips)
        y = draw_strip(svg, figure, strip, scale, y);
    y = draw_note(svg, figure.note, y + 4);
    return svg.document(width, y + 14, figure.title);
}

} // namespace tool::plot
