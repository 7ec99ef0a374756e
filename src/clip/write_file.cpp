// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"
#include "clip/write.hpp"

namespace stltsa::clip {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const std::string& path, int error) {
    fail(Status::io, "{}: cannot write: {}", path, std::generic_category().message(error));
}

/// A file that is open for writing; not open where that failed.
class Descriptor {
  public:
    Descriptor(const char* path, int flags) : number_(::open(path, flags | O_CLOEXEC, 0666)) {}
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool is_open() const { return number_ >= 0; }

    bool write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(number_, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR)
                return false;
            if (written > 0)
                bytes.remove_prefix(static_cast<std::size_t>(written));
        }
        return true;
    }

    /// Gives it the permissions of another file, if that is there.
    bool copy_mode(const char* other) {
        struct stat status {};
        return ::stat(other, &status) != 0 || ::fchmod(number_, status.st_mode & 07777) == 0;
    }

    /// Some file systems tell of a full disk only here.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

/// A new file in a folder, under a name that nobody uses; removed with the object unless renamed.
class TemporaryFile {
  public:
    explicit TemporaryFile(const fs::path& folder) {
        // A name in use is another thread's, or was left by a process that was killed.
        for (int number = 0; number == 0 || errno == EEXIST; ++number) {
            path_ = (folder / format_text(".stltsa-{}-{}.tmp", ::getpid(), number)).string();
            if (Descriptor(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL).is_open())
                return;
        }
        path_.clear();
    }
    ~TemporaryFile() {
        if (!path_.empty())
            ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    bool exists() const { return !path_.empty(); }

    const char* path() const { return path_.c_str(); }

    bool rename(const std::string& to) {
        if (std::rename(path_.c_str(), to.c_str()) != 0)
            return false;
        path_.clear();
        return true;
    }

  private:
    std::string path_;
};

using Content = std::function<void(const Sink&)>;

void fill(Descriptor& file, const Content& content, const std::string& name) {
    content([&](std::string_view piece) {
        if (!file.write(piece))
            cannot_write(name, errno);
    });
    if (!file.close())
        cannot_write(name, errno);
}

void replace_file(const fs::path& place, const Content& content, const std::string& name) {
    TemporaryFile temporary(place.parent_path());
    if (!temporary.exists())
        cannot_write(name, errno);
    Descriptor file(temporary.path(), O_WRONLY);
    if (!file.is_open() || !file.copy_mode(place.c_str()))
        cannot_write(name, errno);
    fill(file, content, name);
    if (!temporary.rename(place.string()))
        cannot_write(name, errno);
}

void write_directly(const std::string& path, const Content& content) {
    Descriptor file(path.c_str(), O_WRONLY);
    if (!file.is_open())
        cannot_write(path, errno);
    fill(file, content, path);
}

} // namespace

void write_file(const std::string& path, std::string_view bytes) {
    write_file(path, [bytes](const Sink& sink) { sink(bytes); });
}

void write_file(const std::string& path, const std::function<void(const Sink&)>& content) {
    if (path.empty())
        fail(Status::io, "the path is empty: give the name of a file");
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        return write_directly(path, content);
    // Links are followed, so that the file they lead to is replaced and not the link.
    const fs::path real = fs::canonical(path, error);
    replace_file(error ? fs::path(path) : real, content, path);
}

} // namespace stltsa::clip
