// SPDX-License-Identifier: BSD-3-Clause
// Writes clips to files.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/sink.hpp"
#include "clip/clip.hpp"

namespace stltsa::clip {

/// Writes the clip in the format of the suffix, completely or not at all.
void write(const Clip& clip, const std::string& path);

/// Writes bytes to a temporary file in the same folder and renames it, so that a file is never
/// incomplete. Pipes and devices are written to directly.
void write_file(const std::string& path, std::string_view bytes);
/// The same for bytes that `content` passes to the sink.
void write_file(const std::string& path, const std::function<void(const Sink&)>& content);

} // namespace stltsa::clip
