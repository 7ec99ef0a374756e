// SPDX-License-Identifier: BSD-3-Clause
// Clips to files.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/sink.hpp"
#include "clip/clip.hpp"

namespace stltsa::clip {

/// Writes the clip in the format that the suffix tells, whole or not at all.
void write(const Clip& clip, const std::string& path);

/// Puts bytes into a file by way of a temporary one beside it, so that the file is never half
/// written. What is no regular file (a pipe, a device) is written to directly.
void write_file(const std::string& path, std::string_view bytes);
/// The same of bytes that `content` hands over.
void write_file(const std::string& path, const std::function<void(const Sink&)>& content);

} // namespace stltsa::clip
