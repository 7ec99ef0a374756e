// SPDX-License-Identifier: BSD-3-Clause
// Files that reach their place whole or not at all. The library and the command are both compiled
// with this (src/meson.build). All of it throws std::system_error.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/sink.hpp"

namespace stltsa::clip {

/// Where links lead, so that the file there is replaced, or made, and not the link.
std::string followed(const std::string& path);

/// Whether a file can be put there; a device or a pipe is written to as it is.
bool regular_or_new(const std::string& path);

/// All of it to an open file.
void write_all(int descriptor, std::string_view bytes);

/// Into what is there already.
void write_directly(const std::string& path, const std::function<void(const Sink&)>& content);

/// A new file beside a place, under a name that nobody uses; removed with the object unless moved.
class TemporaryFile {
  public:
    explicit TemporaryFile(std::string place, const std::string& suffix = "");
    ~TemporaryFile();
    TemporaryFile(TemporaryFile&& other) noexcept;
    TemporaryFile& operator=(TemporaryFile&&) = delete;

    const std::string& name() const { return name_; }
    /// With the permissions of what it replaces, its bytes being on the disk before.
    void move_to_place();

  private:
    std::string place_;
    std::string name_; ///< empty: moved
};

} // namespace stltsa::clip
