// SPDX-License-Identifier: BSD-3-Clause
#include "clip/files/descriptor.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/checkpoint.hpp"

namespace stltsa::clip {
namespace {

/// Waits until the descriptor is ready, for 0.1 s at most. A function that blocked in read(),
/// write() or open() would miss a signal that came just before.
bool ready(int descriptor, short events) {
    constexpr int longest_ms = 100;
    pollfd waited{descriptor, events, 0};
    if (::poll(&waited, 1, 0) > 0)
        return true; // or it failed, and so will reading or writing
    checkpoint();
    const int count = ::poll(&waited, 1, longest_ms);
    require_done(count >= 0 || (Checkpoints::cancellable() && errno == EINTR));
    return count > 0;
}

bool is_pipe(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

} // namespace

void require_done(bool done) {
    if (!done)
        throw std::system_error(errno, std::generic_category());
}

Descriptor::Descriptor(const std::string& path, int flags, mode_t mode) {
    constexpr int nothing = -1; // poll() only waits
    while ((number_ = ::open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, mode)) < 0) {
        // Nobody reads the pipe yet, or another process holds a lease of the file.
        require_done((errno == ENXIO && is_pipe(path)) || errno == EAGAIN || errno == EINTR);
        ready(nothing, 0);
    }
}

Descriptor::~Descriptor() {
    if (number_ >= 0)
        ::close(number_);
}

void Descriptor::close() {
    require_done(::close(std::exchange(number_, -1)) == 0);
}

std::size_t read_some(int descriptor, std::span<char> bytes) {
    for (;;) {
        if (!ready(descriptor, POLLIN))
            continue;
        const ssize_t count = ::read(descriptor, bytes.data(), bytes.size());
        if (count >= 0)
            return static_cast<std::size_t>(count);
        require_done(errno == EINTR || errno == EAGAIN);
        checkpoint();
    }
}

void write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        if (!ready(descriptor, POLLOUT))
            continue;
        // A pipe that is ready takes this much without waiting.
        const ssize_t count =
            ::write(descriptor, bytes.data(), std::min<std::size_t>(bytes.size(), PIPE_BUF));
        require_done(count >= 0 || errno == EINTR || errno == EAGAIN);
        if (count > 0)
            bytes.remove_prefix(static_cast<std::size_t>(count));
        else
            checkpoint();
    }
}

} // namespace stltsa::clip
