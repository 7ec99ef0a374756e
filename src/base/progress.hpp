// SPDX-License-Identifier: BSD-3-Clause
// Progress and cancellation, polled on the caller's thread between blocks of work.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

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

class Progress {
  public:
    using Callback = std::int32_t (*)(void* user, std::int32_t stage, double fraction);

    Progress() = default;
    Progress(Callback callback, void* user) : callback_(callback), user_(user) {}

    /// Progress of part `index` of `count` equal parts of each stage.
    Progress part(std::int64_t index, std::int64_t count) const {
        Progress part = *this;
        part.share_ = share_ / static_cast<double>(count);
        part.begin_ = begin_ + part.share_ * static_cast<double>(index);
        return part;
    }

    /// Progress of work that is a small step of a later stage: reports that stage instead of its
    /// own. The stage spectrum is not reported, because the callback must not fit during it, but
    /// may during the stage that is reported.
    Progress within(Stage stage, double fraction) const {
        Progress part = *this;
        if (!outer_)
            part.outer_ = Reached{stage, begin_ + share_ * fraction};
        return part;
    }

    /// Reports the progress of a stage to the caller; throws Status::cancelled if the callback
    /// returns nonzero.
    void report(Stage stage, double fraction) const {
        if (callback_ == nullptr || (outer_ && stage == Stage::spectrum))
            return;
        const Reached shown = outer_.value_or(Reached{stage, begin_ + share_ * fraction});
        if (callback_(user_, static_cast<std::int32_t>(shown.stage), shown.fraction) != 0)
            fail(Status::cancelled, "cancelled by the progress callback");
    }

  private:
    struct Reached {
        Stage stage;
        double fraction;
    };

    Callback callback_ = nullptr;
    void* user_ = nullptr;
    double begin_ = 0; ///< first fraction of the part
    double share_ = 1;
    std::optional<Reached> outer_; ///< reported instead of the given stage and fraction
};

/// Polls after each fixed amount of work. For loops whose steps are short or long, depending on the
/// clip.
class PacedPoll {
  public:
    explicit PacedPoll(std::function<void()> poll) : poll_(std::move(poll)) {}
    PacedPoll(const Progress& progress, Stage stage, double fraction = 0)
        : poll_([=] { progress.report(stage, fraction); }) {}

    /// Counts numbers that were read or computed.
    void did(std::int64_t numbers) {
        constexpr std::int64_t between_polls = 1 << 22; // some milliseconds
        done_ += numbers;
        if (done_ < between_polls || !poll_)
            return;
        done_ = 0;
        poll_();
    }

  private:
    std::function<void()> poll_;
    std::int64_t done_ = 0;
};

} // namespace stltsa
