// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

namespace tool {

/// A line on stderr that tells how far the work is; wiped away at the end.
class ProgressBar {
  public:
    explicit ProgressBar(bool shown) : shown_(shown) {}
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(std::int32_t stage, double fraction);
    void clear();

    /// For stltsa_options_set_progress; `user` is the bar. Asks to stop after a Ctrl-C.
    static std::int32_t callback(void* user, std::int32_t stage, double fraction);

  private:
    bool shown_;
    bool drawn_ = false;
    std::int32_t stage_ = -1;
    std::chrono::steady_clock::time_point last_{};
};

} // namespace tool
