// SPDX-License-Identifier: BSD-3-Clause
// Calls of a task, and memory for their outputs.
#pragma once

#include "works.hpp"

inline double room[1 << 16]; ///< memory for outputs, of which only the hash is used
inline double more_room[1 << 16];

inline stltsa_status fitted_clip(const stltsa_clip* clip, stltsa_model*& model) {
    return stltsa_fit_clips(&clip, 1, nullptr, &model);
}

/// A whole number that the handle has; -1: it has none.
inline std::int64_t whole_of(const stltsa_info* info, std::int32_t key) {
    std::int64_t value = -1;
    stltsa_info_int(info, key, 0, &value);
    return value;
}

/// Makes calls in order until one fails.
class Calls {
  public:
    /// Makes `call` only if no call has failed. If it fails, the handle must be NULL afterwards.
    template <class Call, class Handle>
    void make(const Call& call, Handle*& handle) {
        if (status_ != STLTSA_OK)
            return;
        status_ = call();
        if (status_ != STLTSA_OK && handle != nullptr)
            status_ = 1;
    }
    template <class Call>
    void make(const Call& call) {
        if (status_ == STLTSA_OK)
            status_ = call();
    }
    bool good() const { return status_ == STLTSA_OK; }
    /// Of the first call that failed; notes the last outputs.
    stltsa_status status() const {
        note(room, 8192);
        note(more_room, 8192);
        return status_;
    }

  private:
    stltsa_status status_ = STLTSA_OK;
};
