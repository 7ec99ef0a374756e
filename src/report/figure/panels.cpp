// SPDX-License-Identifier: BSD-3-Clause
#include "report/figure/panels.hpp"

#include <algorithm>
#include <iterator>

#include "base/text.hpp"
#include "phase/resample.hpp"

namespace stltsa::report {
namespace {

std::vector<double> ticks(const Scale& scale, int most) {
    const double step = nice_step(scale.to - scale.from, most), slack = 1e-9 * step;
    std::vector<double> found;
    for (double i = std::ceil((scale.from - slack) / step); i * step <= scale.to + slack; ++i)
        found.push_back(i * step + 0.0); // not -0
    return found;
}

void draw_tick(Svg& svg, Point from, Point to, Point at, const char* anchor, double value) {
    svg.line(from, to, stroke("tick-line", ink, fine_line));
    svg.text(at, anchor, format_text("{:g}", value),
             fill("tick", ink, 1, format_text(" font-size=\"{}\"", small_font)));
}

} // namespace

const char* unit_color(std::int64_t kind) {
    static constexpr const char* colors[] = {"#56b4e9", "#e69f00", "#0072b2", "#d55e00",
                                             "#cc79a7", "#009e73", "#0072b2", "#f0e442"};
    return colors[static_cast<std::size_t>(kind - 1) % std::size(colors)];
}

const char* label_color(std::int64_t label) {
    static constexpr std::int32_t kinds[] = {
        STLTSA_UNIT_CYCLIC,    STLTSA_UNIT_INITIAL, STLTSA_UNIT_ACTION, STLTSA_UNIT_WIND_UP,
        STLTSA_UNIT_PREPARING, STLTSA_UNIT_FINAL,   STLTSA_UNIT_HOLD};
    return label < 0 ? "#dddddd"
                     : unit_color(kinds[static_cast<std::size_t>(label) % std::size(kinds)]);
}

void Range::add(double value) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
}

Scale Range::scale(double start, double end) const {
    if (low < high)
        return {low, high, start, end};
    const double middle = low > high ? 0 : low;
    return {middle - 1, middle + 1, start, end};
}

double nice_step(double length, int most) {
    const double least = length / most, power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1 - 1e-9))
            return factor * power;
    return 10 * power;
}

void draw_frame(Svg& svg, const Rect& frame) {
    svg.rect(frame, stroke("frame", "#b8b8b8", fine_line));
}

void draw_x_axis(Svg& svg, const Rect& frame, const Scale& x, std::string_view title) {
    const double bottom = frame.bottom();
    for (const double value : ticks(x, static_cast<int>(frame.width / 50)))
        draw_tick(svg, {x(value), bottom}, {x(value), bottom + 4}, {x(value), bottom + 15},
                  "middle", value);
    svg.text({x.middle(), bottom + 28}, "middle", title, fill("axis-title", ink));
}

void draw_y_axis(Svg& svg, const Rect& frame, const Scale& y) {
    for (const double value : ticks(y, 5))
        draw_tick(svg, {frame.x - 4, y(value)}, {frame.x, y(value)}, {frame.x - 6, y(value) + 3.5},
                  "end", value);
    draw_upward(svg, {frame.x - 36, y.middle()}, "motion coordinate");
}

void draw_upward(Svg& svg, Point middle, std::string_view text) {
    svg.text({0, 0}, "middle", text,
             fill("axis-title", ink, 1,
                  format_text(" transform=\"translate({} {}) rotate(-90)\"", number(middle.x),
                              number(middle.y))));
}

std::vector<Stretch> stretches(const Figure& figure, std::int64_t begin, std::int64_t end) {
    const std::vector<stltsa_unit>& units = figure.found.units;
    std::vector<Stretch> found;
    bool joined = false; // with the sample before
    std::size_t unit = 0;
    for (std::int64_t i = begin; i < end; ++i) {
        const std::size_t last = unit;
        while (unit + 1 < units.size() && figure.frame_of(i) >= units[unit].end)
            ++unit;
        const bool known = !std::isnan(figure.rows(i, 0));
        if (known && joined)
            found.back().end = i + 1;
        if (known && (!joined || unit != last))
            found.push_back({i, i + 1, unit_color(units[unit].kind)});
        joined = known;
    }
    return found;
}

void draw_cycles(Svg& svg, const Figure& figure, const Rect& area) {
    constexpr std::int64_t samples = 101, most_lines = 60;
    std::vector<stltsa_part> cycles = figure.found.cycles;
    std::erase_if(cycles, [&](const stltsa_part& cycle) {
        const double middle = figure.sample_of((cycle.begin + cycle.end) / 2);
        return middle < static_cast<double>(figure.begin) ||
               middle >= static_cast<double>(figure.end);
    });
    const std::int64_t count = std::ssize(cycles), lines = std::min(count, most_lines);
    phase::Turns turns{Matrix::unset(count, samples), {}};
    for (std::int64_t i = 0; i < count; ++i) {
        const stltsa_part& cycle = cycles[static_cast<std::size_t>(i)];
        const Scale at{0, samples - 1, figure.sample_of(cycle.begin), figure.sample_of(cycle.end)};
        for (std::int64_t k = 0; k < samples; ++k)
            turns.rows(i, k) = at(static_cast<double>(k));
    }
    const phase::Resampled all = phase::resample(figure.rows.view(), std::move(turns));
    Range range;
    for (const Matrix& cycle : all.each)
        for (std::int64_t k = 0; k < samples; ++k)
            range.add(cycle(k, 0));
    const Scale x{0, samples - 1, area.x, area.right()};
    const Scale y = range.scale(area.bottom() - 8, area.y + 8);
    const auto add = [&](std::vector<Point>& line, std::int64_t k, double value) {
        if (!std::isnan(value))
            line.push_back({x(static_cast<double>(k)), y(value)});
    };
    const char* const color = unit_color(STLTSA_UNIT_CYCLIC);
    for (std::int64_t i = 0; i < lines; ++i) {
        std::vector<Point> line;
        for (std::int64_t k = 0; k < samples; ++k)
            add(line, k, all.each[static_cast<std::size_t>(i * count / lines)](k, 0));
        svg.polyline(line, stroke("overlaid", color, 0.7, " stroke-opacity=\"0.25\""));
    }
    std::vector<Point> above, below, mean;
    for (std::int64_t k = 0; k < samples; ++k) {
        add(mean, k, all.mean(k, 0));
        add(above, k, all.mean(k, 0) + all.deviation(k, 0));
        add(below, k, all.mean(k, 0) - all.deviation(k, 0));
    }
    above.insert(above.end(), below.rbegin(), below.rend());
    svg.polyline(above, fill("deviation", color, 0.25));
    svg.polyline(mean, stroke("mean", color, bold_line));
    draw_frame(svg, area);
    draw_x_axis(
        svg, area, {0, 100, area.x, area.right()},
        "share of the cycle in %" +
            (count > 1 ? format_text("; band: standard deviation of {} cycles", count) : ""));
    draw_y_axis(svg, area, y);
}

} // namespace stltsa::report
