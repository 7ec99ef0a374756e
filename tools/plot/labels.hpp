// SPDX-License-Identifier: BSD-3-Clause
// Text that does not overlap other text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plot/svg.hpp"

namespace tool::plot {

/// Width of a line of text in DejaVu Sans, the widest font that a viewer may use.
double text_width(std::string_view text, double font_size);

/// Breaks text at spaces into lines of at most `width`.
std::vector<std::string> lines_of(std::string_view text, double font_size, double width);

/// The text, or "..." and as much of its end as fits.
std::string shortened(std::string_view text, double font_size, double width);

/// Keeps track of occupied areas.
class LabelSpace {
  public:
    bool free(const Rect& box) const;
    void take(const Rect& box) { taken_.push_back(box); }
    bool take_if_free(const Rect& box);

  private:
    std::vector<Rect> taken_;
};

} // namespace tool::plot
