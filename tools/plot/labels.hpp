// SPDX-License-Identifier: BSD-3-Clause
// Text that does not run into other text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plot/svg.hpp"

namespace tool::plot {

/// Width of a line of text in DejaVu Sans, the widest font that may be used: the one that will be
/// used is not known.
double text_width(std::string_view text, double font_size);

/// Cuts text at blanks into lines of at most `width`.
std::vector<std::string> lines_of(std::string_view text, double font_size, double width);

/// The text, or as much of its end as `width` holds.
std::string shortened(std::string_view text, double font_size, double width);

/// Remembers what is taken.
class LabelSpace {
  public:
    bool free(const Rect& box) const;
    void take(const Rect& box) { taken_.push_back(box); }
    bool take_if_free(const Rect& box);

  private:
    std::vector<Rect> taken_;
};

} // namespace tool::plot
