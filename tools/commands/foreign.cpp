// SPDX-License-Identifier: BSD-3-Clause
#include "commands/foreign.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <span>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "arguments/option_flags.hpp"
#include "arguments/pieces.hpp"
#include "exit_status.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

constexpr std::array suffixes = {".c3d", ".trc", ".mot", ".sto", ".npz"};
constexpr std::string_view rate_mark = "fps ";

/// The interpreter of the package; "" for none.
std::string python_interpreter() {
    const char* python = std::getenv("STLTSA_PYTHON");
    return python == nullptr ? "" : python;
}

[[noreturn]] void cannot_run(const std::string& python, int error) {
    throw Failure(Exit::unreadable,
                  fmt::format("cannot run the Python interpreter {} (STLTSA_PYTHON): {}", python,
                              std::strerror(error)));
}

struct Pipe {
    int ends[2] = {-1, -1};

    Pipe() {
        if (::pipe2(ends, O_CLOEXEC) != 0) // several clips may be read at the same time
            throw Failure(Exit::failed,
                          fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close_end(0);
        close_end(1);
    }

    void close_end(int end) {
        if (ends[end] >= 0)
            ::close(ends[end]);
        ends[end] = -1;
    }
};

pid_t start(const std::string& python, const std::string& path, const std::string& fps,
            const Pipe& output) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output.ends[1], STDOUT_FILENO);
    std::array<std::string, 5> words = {python, "-m", "stltsa.readers", path, fps};
    std::array<char*, 6> arguments{};
    std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });
    pid_t child = -1;
    const int error =
        ::posix_spawnp(&child, python.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        cannot_run(python, error);
    return child;
}

std::string read_all(int from) {
    std::string bytes;
    char block[1 << 16];
    for (;;) {
        const ssize_t count = ::read(from, block, sizeof block);
        if (count > 0)
            bytes.append(block, static_cast<std::size_t>(count));
        else if (count == 0 || errno != EINTR)
            return bytes;
        stop_if_interrupted();
    }
}

/// Exit status of the child.
int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// "fps 120.0", end of line, and the bytes of a file.
ForeignClip clip_in(const std::string& answer, const std::string& path) {
    const std::size_t end = answer.find('\n');
    ForeignClip clip;
    if (end == answer.npos || !answer.starts_with(rate_mark) ||
        std::from_chars(answer.data() + rate_mark.size(), answer.data() + end, clip.fps).ptr !=
            answer.data() + end)
        throw Failure(
            Exit::unreadable,
            fmt::format("{}: the Python package gave no clip (python3 -m stltsa.readers)", path));
    clip.bytes = answer.substr(end + 1);
    return clip;
}

} // namespace

bool is_foreign(const std::string& path) {
    return std::ranges::any_of(suffixes, [&](const char* suffix) { return ends_in(path, suffix); });
}

bool has_python() {
    return !python_interpreter().empty();
}

stltsa::Clip parse_foreign(const ForeignClip& foreign, const std::string& path,
                           const std::map<std::int32_t, std::string>& typed) {
    stltsa::Options options;
    set_options(options, typed);
    if (foreign.fps > 0)
        options.set(STLTSA_OPT_FPS, foreign.fps);
    return stltsa::Clip::parse(std::as_bytes(std::span(foreign.bytes)), 0, options, path);
}

std::optional<ForeignClip> read_by_python(const std::string& path, const std::string& fps) {
    const std::string python = python_interpreter();
    const std::string file = file_of(path);
    if (python.empty() || !is_foreign(file))
        return {};
    Pipe output;
    const pid_t child = start(python, file, fps, output);
    output.close_end(1);
    const std::string answer = read_all(output.ends[0]);
    const int status = wait_for(child);
    if (status == 127)
        cannot_run(python, ENOENT);
    if (status != 0)
        throw Failure(Exit::unreadable,
                      answer.empty() ? fmt::format("{}: the Python package failed", file) : answer);
    return clip_in(answer, file);
}

} // namespace tool
