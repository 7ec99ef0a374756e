// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/sink.hpp"
#include "clip/files/descriptor.hpp"

namespace stltsa::clip {

/// Writes bytes to a temporary file in the same folder and renames it, so that a file is never
/// incomplete. Pipes and devices are written to directly.
void write_file(const std::string& path, std::string_view bytes);
/// The same for bytes that `content` passes to the sink.
void write_file(const std::string& path, const std::function<void(const Sink&)>& content);

} // namespace stltsa::clip
