// SPDX-License-Identifier: BSD-3-Clause
// Progress, and cancellation by the program that called the library, on its own thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/checkpoint.hpp"
#include "base/error.hpp"

namespace stltsa {

/// Same values as STLTSA_STAGE_* in stltsa.h (checked in src/capi).
enum class Stage : std::int32_t {
    read = 0,
    features = 1,
    neighbors = 2,
    tangents = 3,
    alignment = 4,
    spectrum = 5,
    units = 6,
    map = 7,
    denoise = 8,
    synthesis = 9,
    write = 10,
};

/// A call of the library. A progress callback may call the library again.
class Call final : public Checkpoints {
  public:
    using Callback = std::int32_t (*)(void* user, std::int32_t stage, double fraction);

    struct Asked {
        Callback callback = nullptr;
        void* user = nullptr;
    };

    /// `asked`: none if the function takes no options, so that nobody can cancel it.
    explicit Call(const std::optional<Asked>& asked)
        : Checkpoints(asked.has_value()), asked_(asked.value_or(Asked())),
          outer_call_(std::exchange(current_, this)) {
        count_again(); // equal calls ask equally often
    }
    ~Call() { current_ = outer_call_; }

    /// Calls back; throws Status::cancelled if the callback returns nonzero.
    void check() override {
        if (asked_.callback == nullptr || (only_ && *only_ != furthest_.first))
            return;
        if (asked_.callback(asked_.user, static_cast<std::int32_t>(furthest_.first),
                            furthest_.second) != 0)
            fail(Status::cancelled, "cancelled by the progress callback");
    }

    /// For later checkpoints. What the caller sees never decreases.
    static void reach(Stage stage, double fraction) {
        if (current_ != nullptr)
            current_->furthest_ = std::max(current_->furthest_,
                                           {stage, current_->begin_ + current_->share_ * fraction});
    }

  private:
    friend class PartOfStages;
    friend class OnlyInStage;
    static inline constinit thread_local Call* current_ = nullptr;

    Asked asked_;
    Call* outer_call_;
    std::pair<Stage, double> furthest_{Stage::read, 0};
    double begin_ = 0; ///< first fraction of the part
    double share_ = 1;
    std::optional<Stage> only_;
};

/// During its lifetime, stages have part `index` of `count` equal parts of their fractions.
class PartOfStages {
  public:
    PartOfStages(std::int64_t index, std::int64_t count) {
        if (call_ == nullptr)
            return;
        begin_ = call_->begin_;
        share_ = call_->share_;
        call_->share_ = share_ / static_cast<double>(count);
        call_->begin_ = begin_ + call_->share_ * static_cast<double>(index);
    }
    ~PartOfStages() {
        if (call_ == nullptr)
            return;
        call_->begin_ = begin_;
        call_->share_ = share_;
    }
    PartOfStages(const PartOfStages&) = delete;
    PartOfStages& operator=(const PartOfStages&) = delete;

  private:
    Call* call_ = Call::current_;
    double begin_ = 0, share_ = 1; ///< of the call before
};

/// During its lifetime, the callback is called only if it sees this stage.
class OnlyInStage {
  public:
    explicit OnlyInStage(Stage stage) {
        if (call_ != nullptr)
            before_ = std::exchange(call_->only_, stage);
    }
    ~OnlyInStage() {
        if (call_ != nullptr)
            call_->only_ = before_;
    }
    OnlyInStage(const OnlyInStage&) = delete;
    OnlyInStage& operator=(const OnlyInStage&) = delete;

  private:
    Call* call_ = Call::current_;
    std::optional<Stage> before_;
};

/// A checkpoint at which `fraction` of a stage is done.
inline void report_progress(Stage stage, double fraction) {
    Call::reach(stage, fraction);
    checkpoint();
}

} // namespace stltsa
