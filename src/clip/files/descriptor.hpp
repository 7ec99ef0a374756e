// SPDX-License-Identifier: BSD-3-Clause
// Open files whose waits can be cancelled. Compiled into both the library and the command
// (src/meson.build). All functions throw std::system_error.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <sys/types.h>

namespace stltsa::clip {

/// Called about ten times a second while a function waits for the other end of a pipe, and before
/// each piece that write_all() writes. May throw to give up. If it is empty, a signal that is
/// handled ends the wait with an error.
using OnWait = std::function<void()>;

/// Throws errno unless a system call succeeded.
void require_done(bool done);

class Descriptor {
  public:
    /// If a pipe is opened for writing, waits for its reader.
    Descriptor(const std::string& path, int flags, mode_t mode = 0, const OnWait& on_wait = {});
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    /// Some file systems report a full disk only here.
    void close();

  private:
    int number_ = -1;
};

/// Waits for bytes and reads at most `bytes.size()` of them; returns 0 at the end.
std::size_t read_some(int descriptor, std::span<char> bytes, const OnWait& on_wait);

/// Writes all bytes.
void write_all(int descriptor, std::string_view bytes, const OnWait& on_wait = {});

} // namespace stltsa::clip
