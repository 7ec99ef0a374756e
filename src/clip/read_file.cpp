// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"
#include "clip/file_bytes.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::clip {
namespace {

[[noreturn]] void cannot(const char* what, const std::string& path, int error) {
    fail(Status::io, "{}: cannot {}: {}", path, what, std::generic_category().message(error));
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A pipe waits for its writer. A signal ends the wait: the caller may have meant to cancel.
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

/// Bytes of a regular file; 0 where that is not known.
std::size_t size_of(std::FILE* file) {
    struct stat status {};
    const bool known = ::fstat(::fileno(file), &status) == 0 && S_ISREG(status.st_mode);
    return known ? static_cast<std::size_t>(status.st_size) : 0;
}

/// The pages of a regular file.
class MappedFile {
  public:
    explicit MappedFile(const char* path) {
        struct stat status {};
        // To open a pipe lets its writer go on, and to close it again ends that one.
        if (::stat(path, &status) != 0 || !S_ISREG(status.st_mode))
            return;
        const int descriptor = ::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (descriptor < 0)
            return;
        if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
            size_ = static_cast<std::size_t>(status.st_size);
            data_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
        }
        ::close(descriptor);
    }
    ~MappedFile() {
        if (is_mapped())
            ::munmap(data_, size_);
    }
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    bool is_mapped() const { return data_ != MAP_FAILED; }
    std::string_view bytes() const { return {static_cast<const char*>(data_), size_}; }

  private:
    void* data_ = MAP_FAILED;
    std::size_t size_ = 0;
};

} // namespace

FileBytes read_file(const std::string& path, const Progress& progress) {
    if (path.empty())
        fail(Status::io, "the path is empty: give the name of a file");
    // Far above any clip that is not mapped; a device without end stops here.
    constexpr std::size_t most = std::size_t{1} << 34;
    const File file = open_file(path, progress);
    const auto content = std::make_shared<UnsetVector<char>>(); // aligned, as rows may stay in it
    content->reserve(std::min(size_of(file.get()), most));
    std::array<char, 1 << 16> chunk;
    for (;;) {
        const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get());
        content->insert(content->end(), chunk.begin(),
                        chunk.begin() + static_cast<std::ptrdiff_t>(count));
        if (content->size() > most)
            fail(Status::unsupported, "{}: larger than {} bytes", path, most);
        if (count == chunk.size())
            continue;
        if (std::ferror(file.get()) == 0)
            return {{content->data(), content->size()}, content};
        if (errno != EINTR)
            cannot("read", path, errno);
        std::clearerr(file.get());
        progress.report(Stage::read, 0);
    }
}

FileBytes map_file(const std::string& path, const Progress& progress) {
    const auto file = std::make_shared<const MappedFile>(path.c_str());
    if (!file->is_mapped())
        return read_file(path, progress);
    return {file->bytes(), file};
}

} // namespace stltsa::clip
