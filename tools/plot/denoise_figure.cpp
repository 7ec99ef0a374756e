// SPDX-License-Identifier: BSD-3-Clause
#include "plot/denoise_figure.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <stltsa.hpp>

#include "plot/axes.hpp"
#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/scale.hpp"
#include "plot/svg.hpp"
#include "plot/title.hpp"

namespace tool::plot {
namespace {

constexpr double width = 720;
constexpr double left = 54;
constexpr double right = 14;
constexpr double panel_height = 140;
constexpr double residual_height = 80;
constexpr double axis_height = 34;
constexpr double heading = 18;
/// More would not fit on a page.
constexpr std::int64_t most_columns = 3;

const char* const curve_color = unit_colors(STLTSA_UNIT_CYCLIC).line;
constexpr double band_opacity = 0.22;
const char* const moved_color = unit_colors(STLTSA_UNIT_FINAL).line;

/// Points of one coordinate and the fitted curve, before or after denoising; or the residuals,
/// whose curve is the zero line.
struct Panel {
    const DenoiseFigure& figure;
    std::int64_t column;
    const stltsa::Matrix& points;
    const stltsa::Matrix& curve;
    Rect frame;
    Scale time;  ///< row to x
    Scale value; ///< to y

    Point at(const stltsa::Matrix& grid, std::int64_t row, double offset = 0) const {
        return {time(static_cast<double>(row)), value(grid(row, column) + offset)};
    }
    double gamma() const { return figure.gammas[static_cast<std::size_t>(column)]; }
};

using Matrices = std::initializer_list<const stltsa::Matrix*>;

std::pair<double, double> range_of(Matrices matrices, std::int64_t column) {
    double low = INFINITY;
    double high = -HUGE_VAL;
    for (const stltsa::Matrix* grid : matrices)
        for (std::int64_t r = 0; r < grid->rows; ++r) {
            low = std::min(low, (*grid)(r, column));
            high = std::max(high, (*grid)(r, column));
        }
    if (!(low < high))
        return {low - 1, low + 1};
    return {low, high};
}

Panel panel_of(const DenoiseFigure& figure, std::int64_t column, const stltsa::Matrix& points,
               const stltsa::Matrix& curve, std::pair<double, double> range, const Rect& frame) {
    constexpr double air = 8;
    const auto last = static_cast<double>(std::max<std::int64_t>(1, points.rows - 1));
    return {figure,
            column,
            points,
            curve,
            frame,
            {0, last, frame.x + air, frame.right() - air},
            {range.first, range.second, frame.bottom() - air, frame.y + air}};
}

void draw_axes(Svg& svg, const Panel& panel, const std::string& name, bool with_time) {
    const DenoiseFigure& figure = panel.figure;
    draw_frame(svg, panel.frame);
    draw_y_axis(svg, panel.frame, panel.value, 4, "");
    svg.text({panel.frame.x, panel.frame.y - 5}, Anchor::start, name,
             {{"class", "heading"}, {"font-weight", "bold"}});
    const double unit = figure.fps > 0 ? 1 / figure.fps : 1;
    const auto time_of = [&](double row) {
        return (static_cast<double>(figure.first) + row * static_cast<double>(figure.step)) * unit;
    };
    draw_x_axis(
        svg, panel.frame,
        {time_of(panel.time.from), time_of(panel.time.to), panel.time.start, panel.time.end}, 12,
        with_time ? time_title(figure.fps) : "");
}

/// Calls draw(begin, end) for the rows of each piece.
template <class Draw>
void for_pieces(const DenoiseFigure& figure, Draw draw) {
    std::int64_t begin = 0;
    for (const std::int64_t length : figure.lengths) {
        draw(begin, begin + length);
        begin += length;
    }
}

/// The band within gamma of the curve, clipped to the frame.
void draw_band(Svg& svg, const Panel& panel) {
    const auto held = [&](Point p) {
        return Point{p.x, std::clamp(p.y, panel.frame.y, panel.frame.bottom())};
    };
    for_pieces(panel.figure, [&](std::int64_t begin, std::int64_t end) {
        std::vector<Point> outline;
        for (std::int64_t r = begin; r < end; ++r)
            outline.push_back(held(panel.at(panel.curve, r, panel.gamma())));
        for (std::int64_t r = end; r-- > begin;)
            outline.push_back(held(panel.at(panel.curve, r, -panel.gamma())));
        svg.polyline(outline,
                     {{"class", "band"}, {"fill", curve_color}, {"fill-opacity", band_opacity}});
    });
}

void draw_curve(Svg& svg, const Panel& panel) {
    for_pieces(panel.figure, [&](std::int64_t begin, std::int64_t end) {
        std::vector<Point> line;
        for (std::int64_t r = begin; r < end; ++r)
            line.push_back(panel.at(panel.curve, r));
        svg.polyline(line, {{"class", "fitted"},
                            {"fill", "none"},
                            {"stroke", curve_color},
                            {"stroke-width", 1.4},
                            {"stroke-linejoin", "round"}});
    });
}

/// Circles, filled if the point was moved; of coinciding ones only one.
void draw_points(Svg& svg, const Panel& panel, bool moved) {
    std::set<std::pair<long, long>> taken;
    if (moved)
        svg.open("g", {{"fill", moved_color}});
    else
        svg.open("g", {{"fill", "none"}, {"stroke", faint_ink}, {"stroke-width", 0.7}});
    for (std::int64_t r = 0; r < panel.points.rows; ++r) {
        const Point p = panel.at(panel.points, r);
        if ((panel.figure.moves(r, panel.column) != 0) == moved &&
            taken.emplace(std::lround(2 * p.x), std::lround(2 * p.y)).second)
            svg.circle(p, moved ? 1.9 : 1.6, {{"class", moved ? "moved" : "point"}});
    }
    svg.close("g");
}

void draw_panel(Svg& svg, const Panel& panel, const std::string& name, bool with_time) {
    draw_band(svg, panel);
    draw_axes(svg, panel, name, with_time);
    draw_points(svg, panel, false);
    draw_curve(svg, panel);
    draw_points(svg, panel, true);
}

/// The meaning of the marks, in one row; `y`: base line of the text.
void draw_key(Svg& svg, double y) {
    const double middle = y - 3.5;
    svg.circle({left + 4, middle}, 1.6,
               {{"fill", "none"}, {"stroke", faint_ink}, {"stroke-width", 0.7}});
    svg.text({left + 12, y}, Anchor::start, "coordinate");
    svg.circle({left + 96, middle}, 1.9, {{"fill", moved_color}});
    svg.text({left + 104, y}, Anchor::start, "noisy, moved");
    svg.line({left + 196, middle}, {left + 216, middle},
             {{"stroke", curve_color}, {"stroke-width", 1.4}});
    svg.text({left + 222, y}, Anchor::start, "fitted curve");
    svg.rect({left + 310, middle - 5, 20, 10},
             {{"fill", curve_color}, {"fill-opacity", band_opacity}});
    svg.text({left + 336, y}, Anchor::start, "within the noise threshold");
}

double draw_facts(Svg& svg, const DenoiseFigure& figure, double y) {
    for (const std::string& fact : figure.facts)
        for (const std::string& line : lines_of(fact, list_font, width - left - right))
            svg.text({left, y += 15}, Anchor::start, line, {{"font-size", list_font}});
    return y;
}

stltsa::Matrix residuals_of(const DenoiseFigure& figure) {
    stltsa::Matrix residuals = figure.before;
    for (std::size_t i = 0; i < residuals.values.size(); ++i)
        residuals.values[i] -= figure.curve.values[i];
    return residuals;
}

/// One coordinate before and after, on the same scale so that they can be compared, and the
/// residuals.
double draw_column(Svg& svg, const DenoiseFigure& figure, std::int64_t c, double y) {
    const stltsa::Matrix residuals = residuals_of(figure);
    const stltsa::Matrix level(residuals.rows, residuals.cols);
    const auto common = range_of({&figure.before, &figure.after, &figure.curve}, c);
    auto apart = range_of({&residuals}, c);
    const double gamma = figure.gammas[static_cast<std::size_t>(c)];
    apart = {std::min(apart.first, -gamma), std::max(apart.second, gamma)};
    const auto place = [&](double height) {
        const Rect frame{left, y + heading, width - left - right, height};
        y += heading + height + 4;
        return frame;
    };
    const auto named = [&](const char* what) {
        return fmt::format("coordinate {}, {}", c + 1, what);
    };
    draw_panel(svg, panel_of(figure, c, figure.before, figure.curve, common, place(panel_height)),
               named("before denoising"), false);
    draw_panel(svg, panel_of(figure, c, figure.after, figure.curve, common, place(panel_height)),
               named("after denoising"), false);
    draw_panel(svg, panel_of(figure, c, residuals, level, apart, place(residual_height)),
               named("residuals: before denoising, minus the fitted curve"), true);
    return y + axis_height;
}

} // namespace

std::string denoise_figure_svg(const DenoiseFigure& figure) {
    Svg svg;
    double y = draw_title(svg, figure.title, figure.summary, left, width - right) + 20;
    draw_key(svg, y);
    y += 8;
    for (std::int64_t c = 0; c < std::min(figure.curve.cols, most_columns); ++c)
        y = draw_column(svg, figure, c, y);
    y = draw_facts(svg, figure, y + 4);
    return svg.document(width, y + 16, figure.title);
}

} // namespace tool::plot
