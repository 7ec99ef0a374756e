// SPDX-License-Identifier: BSD-3-Clause
#include "clip/files/read_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include "base/checkpoint.hpp"
#include "base/error.hpp"
#include "clip/files/descriptor.hpp"

namespace stltsa::clip {
namespace {

[[noreturn]] void cannot(const char* what, const std::string& path, int error) {
    const char* const hint =
        error == EISDIR ? ": give a file in this folder, or give the folder to stltsa batch" : "";
    fail(error == ENOMEM ? Status::no_memory : Status::io, "{}: cannot {}: {}{}", path, what,
         std::generic_category().message(error), hint);
}

/// Size of a regular file in bytes; 0 if unknown.
std::size_t size_of(const Descriptor& file) {
    struct stat status {};
    const bool known = ::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode);
    return known ? static_cast<std::size_t>(status.st_size) : 0;
}

/// Calls `work`; its errors name the file.
template <class Work>
auto named(const char* what, const std::string& path, Work work) {
    try {
        return work();
    } catch (const std::system_error& error) {
        cannot(what, path, error.code().value());
    }
}

} // namespace

std::string read_file(const std::string& path) {
    if (path.empty())
        fail(Status::io, "the path is empty: give the name of a file");
    // Far larger than any clip; ends the reading of an endless device.
    constexpr std::size_t most = std::size_t{1} << 34;
    const auto file = named("open", path, [&] { return Descriptor(path, O_RDONLY, 0); });
    std::string content;
    content.reserve(std::min(size_of(file), most));
    std::array<char, 1 << 16> chunk;
    while (const auto count =
               named("read", path, [&] { return read_some(file.number(), chunk); })) {
        content.append(chunk.data(), count);
        if (content.size() > most)
            fail(Status::unsupported, "{}: the file is larger than {} bytes", path, most);
        checkpoint();
    }
    return content;
}

} // namespace stltsa::clip
