// SPDX-License-Identifier: BSD-3-Clause
// Errors: a status for programs and a sentence for people.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <utility>

#include "base/text.hpp"

namespace stltsa {

/// Same values as STLTSA_OK, STLTSA_E_*, ... in stltsa.h (checked in src/capi).
enum class Status : std::int32_t {
    ok = 0,
    argument = -1,
    shape = -2,
    not_finite = -3,
    too_few_frames = -4,
    no_memory = -5,
    io = -6,
    format = -7,
    disconnected = -8,
    degenerate = -9,
    not_converged = -10,
    cancelled = -11,
    unsupported = -12,
    internal = -13,
    no_common_posture = -14,
    no_such_part = -15,
};

class Error : public std::exception {
  public:
    Error(Status status, std::string text) : status_(status), text_(std::move(text)) {}
    Status status() const noexcept { return status_; }
    const char* what() const noexcept override { return text_.c_str(); }

  private:
    Status status_;
    std::string text_;
};

/// Throws an Error whose text names the fault, its place and the remedy.
template <class... Args>
[[noreturn]] void fail(Status status, fmt::format_string<Args...> text, Args&&... args) {
    throw Error(status, format_text(text, std::forward<Args>(args)...));
}

} // namespace stltsa
