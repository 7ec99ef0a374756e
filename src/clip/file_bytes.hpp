// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace stltsa::clip {

/// Bytes of a file and what keeps them, so that what is read may stay where it lies. Without an
/// owner they are someone else's, and whatever is to stay must be copied.
struct FileBytes {
    std::string_view bytes;
    std::shared_ptr<const void> owner;
};

/// Reads the whole file; Status::io with the system's reason where it cannot be read. `progress` is
/// asked whether to go on after a signal.
FileBytes read_file(const std::string& path, const Progress& progress);

/// Maps the file into memory, so that pages are read when they are first looked at and need no room
/// of their own. What is no regular file is read. What others write into the file changes the
/// bytes; where they cut it short, the system ends the process (SIGBUS).
FileBytes map_file(const std::string& path, const Progress& progress);

} // namespace stltsa::clip
