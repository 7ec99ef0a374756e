// SPDX-License-Identifier: BSD-3-Clause
// What the panels of the figure show and share.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "report/figure/side_view.hpp"
#include "report/figure/svg.hpp"
#include "results/decomposed.hpp"

namespace stltsa::report {

struct Figure {
    const results::Decomposed& found;
    const results::ClipFacts& clip;
    Matrix rows;                         ///< see curve_rows()
    std::int64_t begin = 0, end = 0;     ///< samples of the loop and of the overlaid cycles
    const stltsa_part* chosen = nullptr; ///< the cycle that stands out; null: none does
    bool dense = false;                  ///< too many cycles to be told apart
    bool several = false;                ///< more than one segment moves

    std::int64_t frame_of(std::int64_t sample) const {
        return found.source.samples.first + sample * found.source.samples.step;
    }
    /// Where a frame is among the samples.
    double sample_of(std::int64_t frame) const {
        return static_cast<double>(frame - frame_of(0)) /
               static_cast<double>(found.source.samples.step);
    }
};

/// The colors of a STLTSA_UNIT_* and of a label, from those of Okabe and Ito ("Color Universal
/// Design", 2008), which color-blind readers can tell apart.
const char* unit_color(std::int64_t kind);
const char* label_color(std::int64_t label);

/// From values to positions in the figure.
struct Scale {
    double from, to; ///< values at `start` and `end`
    double start, end;

    double operator()(double value) const {
        return start + (value - from) / (to - from) * (end - start);
    }
    double middle() const { return 0.5 * (start + end); }
};

/// The values that a panel shows.
struct Range {
    double low = INFINITY, high = -INFINITY;

    void add(double value); ///< NaN is left out
    /// If all values are equal they are in the middle.
    Scale scale(double start, double end) const;
};

/// The smallest 1, 2 or 5 times a power of ten such that at most `most` steps fill `length`.
double nice_step(double length, int most);
void draw_frame(Svg& svg, const Rect& frame);
void draw_x_axis(Svg& svg, const Rect& frame, const Scale& x, std::string_view title);
void draw_y_axis(Svg& svg, const Rect& frame, const Scale& y);
/// A title that reads upward, centered at a point.
void draw_upward(Svg& svg, Point middle, std::string_view text);

/// Samples [begin, end) that one line of one color connects. It ends where the next one begins.
struct Stretch {
    std::int64_t begin, end;
    const char* color; ///< of the unit
};
/// Those of [begin, end) that have a curve, split where the unit changes.
std::vector<Stretch> stretches(const Figure& figure, std::int64_t begin, std::int64_t end);

/// The curve over time with units, cycles and, if `body` is given, postures (Fig. 3 of the paper).
void draw_time(Svg& svg, const Figure& figure, SideView* body, const Rect& area);
/// Two coordinates of the curve, with frame numbers (Fig. 1).
void draw_loop(Svg& svg, const Figure& figure, const Rect& area);
/// The curve of each cycle on 0 to 100 %, with mean and standard deviation.
void draw_cycles(Svg& svg, const Figure& figure, const Rect& area);

} // namespace stltsa::report
