// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>
#include <utility>

#include <stltsa.hpp>

namespace tool {

/// Exit status of the command; documented in the manual page.
enum class Exit {
    done = 0, ///< "no cycle" is a valid answer
    failed = 1,
    usage = 2,
    unreadable = 3,    ///< the input
    untrustworthy = 4, ///< the input gives no reliable result
    partly = 5,        ///< batch: some clips failed
    interrupted = 130, ///< 128 + SIGINT, as in shells
};

/// Ends the command: a sentence for stderr and the exit status.
class Failure : public std::exception {
  public:
    Failure(Exit status, std::string text) : status_(status), text_(std::move(text)) {}
    /// From an error of the library; options are named as the flags that the user types.
    explicit Failure(const stltsa::Error& error);
    Exit status() const noexcept { return status_; }
    const char* what() const noexcept override { return text_.c_str(); }

  private:
    Exit status_;
    std::string text_;
};

/// From an error of a call that reads the input: if the input is to blame, it is unreadable.
Failure unreadable(const stltsa::Error& error);

} // namespace tool
