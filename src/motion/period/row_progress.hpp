// SPDX-License-Identifier: BSD-3-Clause
// Progress through the rows of a recording, some of which are visited again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

#include "base/progress.hpp"

namespace stltsa::motion {

class RowProgress {
  public:
    RowProgress(const Progress& progress, std::int64_t rows)
        : progress_(progress), rows_(static_cast<double>(rows)) {}

    /// Reports the farthest row so far. Throws Status::cancelled.
    void reached(double row) {
        farthest_ = std::max(farthest_, std::min(row / rows_, 1.0));
        progress_.report(Stage::units, farthest_);
    }

    /// Reports the farthest row again. Valid as long as this object.
    std::function<void()> poll() {
        return [this] { reached(0); };
    }

  private:
    const Progress& progress_;
    double rows_;
    double farthest_ = 0;
};

} // namespace stltsa::motion
