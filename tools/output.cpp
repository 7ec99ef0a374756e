// SPDX-License-Identifier: BSD-3-Clause
#include "output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exit_status.hpp"

namespace tool {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_writing(const std::string& name) {
    const int why = errno;
    throw Failure(Exit::failed, fmt::format("cannot write {}: {}", name, std::strerror(why)));
}

/// A file that is open for writing.
class Descriptor {
  public:
    Descriptor(const std::string& path, int flags) : number_(::open(path.c_str(), flags, 0666)) {}
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool good() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Some file systems tell of a full disk only here.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

bool write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno != EINTR)
            return false;
        if (written > 0)
            text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// Where links lead, so that the file there is replaced, or made, and not the link.
std::string followed(const std::string& path) {
    std::error_code missing;
    const fs::path real = fs::canonical(path, missing);
    if (!missing)
        return real.string();
    fs::path place = path;
    constexpr int most_links = 40; // a ring of them leads nowhere
    std::error_code error;
    for (int i = 0; i < most_links && !fs::exists(place, error); ++i) {
        const fs::path next = fs::read_symlink(place, error);
        if (error) // no link
            break;
        place = place.parent_path() / next;
    }
    return place.string();
}

bool regular_or_new(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return !fs::exists(status) || fs::is_regular_file(status);
}

/// Of files, there already or not; any number of results may go to /dev/null.
bool same_place(const std::string& path, const std::string& other) {
    std::error_code none;
    const auto place_of = [&none](const std::string& name) {
        return fs::weakly_canonical(fs::absolute(followed(name), none), none);
    };
    return regular_or_new(path) && place_of(path) == place_of(other);
}

/// A name beside `path` that nobody uses, not even a run that was killed.
std::string unused_name(const std::string& path) {
    std::string name;
    int number = 0;
    std::error_code ignored;
    do
        name = fmt::format("{}.{}-{}.tmp", path, ::getpid(), ++number);
    while (fs::exists(fs::symlink_status(name, ignored)));
    return name;
}

/// `name`: of the place, as it was given.
void write_beside(const std::string& place, const std::string& temporary, std::string_view content,
                  const std::string& name) {
    Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
    if (!file.good())
        fail_writing(name);
    struct stat existing {};
    const bool replaces = ::stat(place.c_str(), &existing) == 0;
    const bool written = (!replaces || ::fchmod(file.number(), existing.st_mode & 07777) == 0) &&
                         write_all(file.number(), content) && file.close();
    if (!written) {
        const int why = errno;
        ::unlink(temporary.c_str());
        errno = why;
        fail_writing(name);
    }
}

void write_directly(const std::string& place, std::string_view content, const std::string& name) {
    Descriptor file(place, O_WRONLY | O_CLOEXEC);
    if (!file.good() || !write_all(file.number(), content) || !file.close())
        fail_writing(name);
}

} // namespace

void write_stdout(std::string_view text) {
    if (!write_all(STDOUT_FILENO, text))
        fail_writing("standard output");
}

OutputFiles::~OutputFiles() {
    for (const Staged& file : staged_)
        if (!file.temporary.empty())
            ::unlink(file.temporary.c_str());
}

void OutputFiles::add(const std::string& path, std::string content) {
    const std::string place = followed(path);
    if (!regular_or_new(place)) {
        staged_.push_back({path, place, "", std::move(content), {}});
        return;
    }
    const std::string temporary = unused_name(place);
    write_beside(place, temporary, content, path);
    staged_.push_back({path, place, temporary, "", {}});
}

void OutputFiles::add_written(const std::string& path, Write write) {
    const std::string place = followed(path);
    if (!regular_or_new(place)) {
        staged_.push_back({path, path, "", "", std::move(write)}); // the link has the suffix
        return;
    }
    const std::string temporary = unused_name(place) + fs::path(path).extension().string();
    staged_.push_back({path, place, temporary, "", {}});
    try {
        write(temporary);
    } catch (const Failure& failure) { // the user knows the place, not the name beside it
        std::string text = failure.what();
        if (text.starts_with(temporary))
            text.replace(0, temporary.size(), path);
        throw Failure(failure.status(), std::move(text));
    }
    struct stat existing {};
    if (::stat(place.c_str(), &existing) == 0 &&
        ::chmod(temporary.c_str(), existing.st_mode & 07777) != 0)
        fail_writing(path);
}

void OutputFiles::commit() {
    for (Staged& file : staged_) {
        if (file.write)
            file.write(file.place);
        else if (file.temporary.empty())
            write_directly(file.place, file.content, file.name);
        else if (std::rename(file.temporary.c_str(), file.place.c_str()) != 0)
            fail_writing(file.name);
        file.temporary.clear();
    }
    staged_.clear();
}

void check_output_place(const std::string& path, const std::vector<std::string>& taken) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::status_known(status) || fs::is_directory(status)) {
        errno = fs::is_directory(status) ? EISDIR : error.value();
        fail_writing(path);
    }
    for (const std::string& other : taken)
        if (same_place(path, other))
            throw Failure(Exit::usage,
                          fmt::format("{} is an input, or given for two outputs", path));
    const fs::path place = followed(path);
    if (!regular_or_new(place.string()))
        return;
    const std::string folder = place.has_parent_path() ? place.parent_path().string() : ".";
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        fail_writing(path);
}

} // namespace tool
