// SPDX-License-Identifier: BSD-3-Clause
// Replaces files completely or not at all. Compiled into both the library and the command
// (src/meson.build). All functions throw std::system_error.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <system_error>

#include "base/sink.hpp"
#include "clip/files/descriptor.hpp"

namespace stltsa::clip {

/// Resolves symbolic links, so that their target is replaced or created instead of the link.
std::string followed(const std::string& path);

/// Whether the path is a regular file or does not exist; devices and pipes are written to directly.
bool regular_or_new(const std::string& path);

/// The system's reason for which a file could not be written, and what to do.
std::string why_not_written(const std::error_code& error);

/// Writes into an existing file, device or pipe. Opening a pipe waits for its reader; if the reader
/// leaves, the function fails, and SIGPIPE does not end the process.
void write_directly(const std::string& path, const std::function<void(const Sink&)>& content);

/// A new file in the folder of `place` with an unused name; deleted with the object unless moved.
/// Temporary files that killed processes left more than an hour ago are deleted, too.
class TemporaryFile {
  public:
    explicit TemporaryFile(std::string place, const std::string& suffix = "");
    ~TemporaryFile();
    TemporaryFile(TemporaryFile&& other) noexcept;
    TemporaryFile& operator=(TemporaryFile&&) = delete;

    const std::string& name() const { return name_; }
    /// Fails if the name was replaced by a link.
    void write(const std::function<void(const Sink&)>& content) const;
    /// Replaces the file at `place`, with its permissions, after all bytes are on the disk. When it
    /// returns, the new name is on the disk, too.
    void move_to_place();

  private:
    std::string place_;
    std::string name_; ///< empty: moved
};

} // namespace stltsa::clip
