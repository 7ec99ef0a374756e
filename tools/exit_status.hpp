// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>
#include <utility>

#include <stltsa.hpp>

namespace tool {

/// What the command says to the shell; documented in the manual page.
enum class Exit {
    done = 0, ///< "no cycle" is an answer too
    failed = 1,
    usage = 2,
    unreadable = 3,    ///< the input
    untrustworthy = 4, ///< the input gives no result that can be relied on
    interrupted = 130, ///< 128 + SIGINT, as shells have it
};

/// Ends the command: a sentence for stderr and the exit status.
class Failure : public std::exception {
  public:
    Failure(Exit status, std::string text) : status_(status), text_(std::move(text)) {}
    /// What the library refuses, flags being named as the user types them.
    explicit Failure(const stltsa::Error& error);
    Exit status() const noexcept { return status_; }
    const char* what() const noexcept override { return text_.c_str(); }

  private:
    Exit status_;
    std::string text_;
};

/// The same of a call that reads the input: whatever is wrong with it makes it unreadable.
Failure unreadable(const stltsa::Error& error);

} // namespace tool
