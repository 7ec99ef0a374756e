// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/names.hpp"
#include "base/text.hpp"
#include "report/figure/panels.hpp"
#include "results/phased.hpp"

namespace stltsa::report {
namespace {

constexpr double row_height = 16, air = 12, number_row = 12, posture_height = 84;

/// A figure whose time runs along a frame.
struct TimePanel {
    Svg& svg;
    const Figure& figure;
    Rect frame;
    Scale time;  ///< of frames
    Scale value; ///< of the curve

    double x_of(std::int64_t at) const { return time(static_cast<double>(at)); }
    template <class Part>
    Rect box(const Part& part, double y, double height) const {
        const double begin = x_of(part.begin);
        return {begin, y, std::max(0.0, x_of(part.end) - begin), height};
    }
    void draw_bar(const Rect& bar, const std::string& style, const char* color,
                  std::initializer_list<std::string> texts) const;
    double draw_bars(double y) const;
    void draw_bands() const;
    void draw_curve() const;
    void draw_postures(SideView& body) const;
};

/// A bar, with the first of the texts that fits. `color`: below the text.
void TimePanel::draw_bar(const Rect& bar, const std::string& style, const char* color,
                         std::initializer_list<std::string> texts) const {
    const std::string_view dark[] = {unit_color(STLTSA_UNIT_CYCLIC), unit_color(STLTSA_UNIT_FINAL),
                                     unit_color(STLTSA_UNIT_ACTION)};
    const bool on_dark = std::ranges::find(dark, color) != std::end(dark);
    svg.rect(bar, style);
    for (const std::string& text : texts)
        if (text_width(text, font) + 2 <= bar.width)
            return svg.text({bar.x + 0.5 * bar.width, bar.y + 0.5 * bar.height + 4}, "middle", text,
                            fill("bar-text", on_dark ? white : ink));
}

/// Segments if more than one moves, units, and cycles unless there are too many. Returns the y
/// below.
double TimePanel::draw_bars(double y) const {
    constexpr double height = row_height - 1;
    for (const stltsa_segment& segment : figure.found.segments) {
        if (!figure.several)
            break;
        const char* const color = label_color(segment.label);
        const std::string label = letters_of(segment.label);
        const bool once = segment.kind == STLTSA_SEGMENT_ACTION;
        const char* const what =
            segment.kind == STLTSA_SEGMENT_REPETITIONS ? "repetition" : "cycle";
        draw_bar(box(segment, y, height), fill("segment", color, once ? 0.3 : 1),
                 once ? white : color,
                 {once || segment.label < 0 ? label : label + " · " + counted(segment.count, what),
                  label});
    }
    y += figure.several ? row_height : 0;
    for (const stltsa_unit& unit : figure.found.units)
        draw_bar(box(unit, y, height), fill("unit", unit_color(unit.kind)), unit_color(unit.kind),
                 {name_of(unit_kinds, unit.kind)});
    y += row_height;
    if (figure.dense || figure.found.cycles.empty())
        return y;
    const char* const color = unit_color(STLTSA_UNIT_CYCLIC);
    for (std::size_t i = 0; i < figure.found.cycles.size(); ++i) {
        const char* const inside = &figure.found.cycles[i] == figure.chosen ? color : white;
        draw_bar(box(figure.found.cycles[i], y, height - 1),
                 fill("cycle", inside, 1, format_text(" stroke=\"{}\"", color)), inside,
                 {format_text("cycle {}", i + 1), format_text("{}", i + 1)});
    }
    return y + row_height;
}

/// A faint band behind each unit, a darker one behind the representative cycle, and dashed lines at
/// the borders of cycles. They end where the postures begin, so that no number lies on a line.
void TimePanel::draw_bands() const {
    for (const stltsa_unit& unit : figure.found.units)
        svg.rect(box(unit, frame.y, frame.height), fill("band", unit_color(unit.kind), 0.13));
    const char* const color = unit_color(STLTSA_UNIT_CYCLIC);
    std::int64_t last = -1;
    if (figure.chosen != nullptr)
        svg.rect(box(*figure.chosen, frame.y, frame.height), fill("chosen", color, 0.13));
    for (const stltsa_part& cycle : figure.found.cycles)
        for (const std::int64_t edge : {cycle.begin, cycle.end})
            if (const double x = x_of(edge); !figure.dense && edge != last) {
                svg.line({x, value.end - air}, {x, value.start + air},
                         stroke("margin", color, fine_line, " stroke-dasharray=\"3 2.5\""));
                last = edge;
            }
}

/// Of the points in a third of a unit of x, which are one for the eye, the lowest and the highest.
std::vector<Point> thinned(const std::vector<Point>& points) {
    std::vector<Point> kept;
    for (std::size_t i = 0, end = 0; i < points.size(); i = end) {
        std::size_t low = i, high = i;
        for (end = i; end < points.size() && points[end].x < points[i].x + 1.0 / 3; ++end) {
            low = points[end].y < points[low].y ? end : low;
            high = points[end].y > points[high].y ? end : high;
        }
        kept.push_back(points[std::min(low, high)]);
        if (low != high)
            kept.push_back(points[std::max(low, high)]);
    }
    return kept;
}

/// The curve, and a dotted line where there is none.
void TimePanel::draw_curve() const {
    double end = frame.x;
    const auto gap_to = [&](double x) {
        if (constexpr double least = 3; x - end > least)
            svg.line({end, value.middle()}, {x, value.middle()},
                     stroke("no-curve", faint_ink, fine_line, " stroke-dasharray=\"1 3\""));
    };
    for (const Stretch& stretch : stretches(figure, 0, figure.rows.rows())) {
        std::vector<Point> points;
        for (std::int64_t i = stretch.begin; i < stretch.end; ++i)
            points.push_back({x_of(figure.frame_of(i)), value(figure.rows(i, 0))});
        gap_to(points.front().x);
        svg.curve(thinned(points), stroke("curve", stretch.color, figure.dense ? 0.7 : bold_line,
                                          " stroke-linejoin=\"round\""));
        end = x_of(figure.frame_of(stretch.end));
    }
    gap_to(frame.right());
}

/// Moves every second place, from `first`, so that they are `room` apart and inside the frame.
void spread(std::vector<double>& places, std::size_t first, const Rect& frame, double room) {
    double least = frame.x + 0.5 * room, most = frame.right() - 0.5 * room;
    for (std::size_t i = first; i < places.size(); i += 2)
        least = (places[i] = std::max(places[i], least)) + room;
    for (std::size_t i = places.size(); i-- > first;)
        if ((i - first) % 2 == 0)
            most = (places[i] = std::min(places[i], most)) - room;
}

/// Postures alternately above and below the curve, each near its time and joined to its point.
void TimePanel::draw_postures(SideView& body) const {
    double wide = 0, tall = 0;
    const std::int64_t step = 1 + figure.clip.frames / 200;
    for (std::int64_t i = 0; i < figure.clip.frames; i += step) {
        const Rect around = body.box(i);
        wide = std::max(wide, around.width);
        tall = std::max(tall, around.height);
    }
    if (!(tall > 0))
        return;
    std::vector<std::int64_t> frames = figure.found.postures; // the first n are the choice of n
    frames.resize(std::min<std::size_t>(frames.size(), 13));
    std::ranges::sort(frames);
    const double widest = 2 * frame.width / static_cast<double>(frames.size() + 1);
    const double scale = std::min((posture_height - number_row - 6) / tall, (widest - 4) / wide);
    std::vector<double> x;
    for (const std::int64_t at : frames)
        x.push_back(x_of(at));
    for (const std::size_t first : {0U, 1U})
        spread(x, first, frame, std::min(widest, std::max(32.0, wide * scale + 4)));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const bool above = i % 2 == 0;
        const double ground = above ? value.end - 14 : frame.bottom() - number_row - 3;
        const double top = ground - scale * body.box(frames[i]).height - 4;
        const double y = value(figure.rows(std::llround(figure.sample_of(frames[i])), 0));
        const Point dot{x_of(frames[i]), std::isnan(y) ? value.middle() : y};
        svg.line(dot, {x[i], above ? ground + 3 : top}, stroke("tie", faint_ink, 0.6));
        svg.circle(dot, 2.2, fill("tied", white, 1, " stroke=\"#222222\""));
        body.draw(svg, frames[i], {x[i], ground}, scale);
        svg.number_text({x[i], above ? top : ground + number_row}, format_text("{}", frames[i]),
                        "posture-number");
    }
}

} // namespace

void draw_time(Svg& svg, const Figure& figure, SideView* body, const Rect& area) {
    const double frames = static_cast<double>(figure.clip.frames);
    TimePanel panel{svg, figure, area, {0, frames, area.x, area.right()}, {}};
    const double top = panel.draw_bars(area.y);
    panel.frame = {area.x, top, area.width, area.bottom() - top - 32};
    Range range;
    for (std::int64_t i = 0; i < figure.rows.rows(); ++i)
        range.add(figure.rows(i, 0));
    const double margin = air + (body != nullptr ? posture_height : 0);
    panel.value = range.scale(panel.frame.bottom() - margin, top + margin);
    panel.draw_bands();
    draw_frame(svg, panel.frame);
    draw_x_axis(svg, panel.frame, {0, frames / figure.clip.fps, area.x, area.right()},
                "time in seconds");
    if (figure.begin < figure.end)
        draw_y_axis(svg, panel.frame, panel.value);
    panel.draw_curve();
    if (body != nullptr)
        panel.draw_postures(*body);
}

} // namespace stltsa::report
