// SPDX-License-Identifier: BSD-3-Clause
// Whatever may take long calls checkpoint(), which asks whether to go on: guard() opens a Call,
// whose progress callback answers. Compiled into both the library and the command
// (src/meson.build).
#pragma once

#include <cstdint>
#include <utility>

namespace stltsa {

/// Answers the checkpoints of the thread that made it during its lifetime. An inner one hides the
/// outer one.
class Checkpoints {
  public:
    Checkpoints(const Checkpoints&) = delete;
    Checkpoints& operator=(const Checkpoints&) = delete;

    /// May throw to end the work.
    virtual void check() = 0;

    static Checkpoints* innermost() { return innermost_; }
    /// Whether somebody can end the work of this thread.
    static bool cancellable() { return innermost_ != nullptr && innermost_->cancellable_; }

    /// Counts work; true after each few million numbers that were read or computed.
    static bool due(std::int64_t numbers) {
        constexpr std::int64_t between_checks = 1 << 22; // some milliseconds
        numbers_ += numbers;
        if (numbers_ < between_checks)
            return false;
        numbers_ = 0;
        return true;
    }

  protected:
    explicit Checkpoints(bool cancellable)
        : cancellable_(cancellable), outer_(std::exchange(innermost_, this)) {}
    ~Checkpoints() { innermost_ = outer_; }
    Checkpoints* outer() const { return outer_; }
    static void count_again() { numbers_ = 0; }

  private:
    static inline constinit thread_local Checkpoints* innermost_ = nullptr;
    static inline constinit thread_local std::int64_t numbers_ = 0;

    bool cancellable_;
    Checkpoints* outer_;
};

/// Asks whether to go on; throws if not. For steps that may take milliseconds.
inline void checkpoint() {
    if (Checkpoints* checkpoints = Checkpoints::innermost())
        checkpoints->check();
}

/// The same after each few million numbers that were read or computed. For loops whose steps are
/// short or long, depending on the clip.
inline void checkpoint(std::int64_t numbers) {
    if (Checkpoints::due(numbers))
        checkpoint();
}

} // namespace stltsa
