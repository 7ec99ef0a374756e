// SPDX-License-Identifier: BSD-3-Clause
#include "clip/files/read_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <sys/stat.h>

#include "base/error.hpp"

namespace stltsa::clip {
namespace {

[[noreturn]] void cannot(const char* what, const std::string& path, int error) {
    const char* const hint =
        error == EISDIR ? ": give a file in this folder, or give the folder to stltsa batch" : "";
    fail(error == ENOMEM ? Status::no_memory : Status::io, "{}: cannot {}: {}{}", path, what,
         std::generic_category().message(error), hint);
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Opening a pipe waits for its writer. A signal ends the wait, so that the caller can cancel.
File open_file(const std::string& path, const Progress& progress) {
    for (;;) {
        File file(std::fopen(path.c_str(), "rb"), &std::fclose);
        if (file)
            return file;
        if (errno != EINTR)
            cannot("open", path, errno);
        progress.report(Stage::read, 0);
    }
}

/// Size of a regular file in bytes; 0 if unknown.
std::size_t size_of(std::FILE* file) {
    struct stat status {};
    const bool known = ::fstat(::fileno(file), &status) == 0 && S_ISREG(status.st_mode);
    return known ? static_cast<std::size_t>(status.st_size) : 0;
}

} // namespace

std::string read_file(const std::string& path, const Progress& progress) {
    if (path.empty())
        fail(Status::io, "the path is empty: give the name of a file");
    // Far larger than any clip; ends the reading of an endless device.
    constexpr std::size_t most = std::size_t{1} << 34;
    const File file = open_file(path, progress);
    std::string content;
    content.reserve(std::min(size_of(file.get()), most));
    std::array<char, 1 << 16> chunk;
    for (;;) {
        const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get());
        content.append(chunk.data(), count);
        if (content.size() > most)
            fail(Status::unsupported, "{}: the file is larger than {} bytes", path, most);
        if (count < chunk.size()) {
            if (std::ferror(file.get()) == 0)
                return content;
            if (errno != EINTR)
                cannot("read", path, errno);
            std::clearerr(file.get());
        }
        progress.report(Stage::read, 0);
    }
}

} // namespace stltsa::clip
