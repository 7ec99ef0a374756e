// SPDX-License-Identifier: BSD-3-Clause
#include "plot/axes.hpp"

#include "plot/palette.hpp"

namespace tool::plot {

std::string_view time_title(double fps) {
    return fps > 0 ? "time in seconds" : "frame";
}

void draw_frame(Svg& svg, const Rect& frame) {
    svg.rect(
        frame,
        {{"class", "frame"}, {"fill", "none"}, {"stroke", hairline}, {"stroke-width", thin_line}});
}

void draw_x_axis(Svg& svg, const Rect& frame, const Scale& scale, int most,
                 std::string_view title) {
    const double bottom = frame.bottom();
    for (const Tick& tick : nice_ticks(scale.from, scale.to, most)) {
        const double x = scale(tick.value);
        svg.line({x, bottom}, {x, bottom + 4}, {{"stroke", ink}, {"stroke-width", thin_line}});
        if (!title.empty())
            svg.text({x, bottom + 15}, Anchor::middle, tick.label,
                     {{"class", "tick"}, {"font-size", small_font}});
    }
    if (!title.empty())
        svg.text({frame.x + 0.5 * frame.width, bottom + 28}, Anchor::middle, title,
                 {{"class", "axis-title"}});
}

void draw_y_axis(Svg& svg, const Rect& frame, const Scale& scale, int most,
                 std::string_view title) {
    for (const Tick& tick : nice_ticks(scale.from, scale.to, most)) {
        const double y = scale(tick.value);
        svg.line({frame.x - 4, y}, {frame.x, y}, {{"stroke", ink}, {"stroke-width", thin_line}});
        svg.text({frame.x - 6, y + 3.5}, Anchor::end, tick.label, {{"font-size", small_font}});
    }
    if (!title.empty())
        draw_upward(svg, {frame.x - 36, 0.5 * (scale.start + scale.end)}, title);
}

void draw_upward(Svg& svg, Point middle, std::string_view text) {
    svg.open("g", {{"transform",
                    "translate(" + number(middle.x) + " " + number(middle.y) + ") rotate(-90)"}});
    svg.text({0, 0}, Anchor::middle, text, {{"class", "axis-title"}});
    svg.close("g");
}

} // namespace tool::plot
