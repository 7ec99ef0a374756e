// SPDX-License-Identifier: BSD-3-Clause
// Open files whose waits can be cancelled: a checkpoint comes before each wait for the other end of
// a pipe, and ten times a second during it. If nobody can cancel, a signal that is handled ends the
// wait with an error. Compiled into both the library and the command (src/meson.build). All
// functions throw std::system_error.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <sys/types.h>

namespace stltsa::clip {

/// Throws errno unless a system call succeeded.
void require_done(bool done);

class Descriptor {
  public:
    /// If a pipe is opened for writing, waits for its reader.
    Descriptor(const std::string& path, int flags, mode_t mode = 0);
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
std::size_t read_some(int descriptor, std::span<char> bytes);

/// Writes all bytes.
void write_all(int descriptor, std::string_view bytes);

} // namespace stltsa::clip
