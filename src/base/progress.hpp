// SPDX-License-Identifier: BSD-3-Clause
// Progress and cancellation, polled on the caller's thread between blocks of work.
#pragma once

#include <cstdint>

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

    /// Reports the progress of a stage to the caller; throws Status::cancelled if the callback
    /// returns nonzero.
    void report(Stage stage, double fraction) const {
        if (callback_ != nullptr &&
            callback_(user_, static_cast<std::int32_t>(stage), begin_ + share_ * fraction) != 0)
            fail(Status::cancelled, "cancelled by the progress callback");
    }

  private:
    Callback callback_ = nullptr;
    void* user_ = nullptr;
    double begin_ = 0; ///< first fraction of the part
    double share_ = 1;
};

} // namespace stltsa
