// SPDX-License-Identifier: BSD-3-Clause
#include "commands/foreign.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "arguments/pieces.hpp"
#include "exit_status.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

constexpr std::array suffixes = {".c3d", ".trc", ".mot", ".sto", ".npz"};

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

/// The arguments of the module stltsa.readers.
using Words = std::vector<std::string>;

pid_t start(const std::string& python, const Words& given, const Pipe& output) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output.ends[1], STDOUT_FILENO);
    std::vector<std::string> words = {python, "-m", "stltsa.readers"};
    words.insert(words.end(), given.begin(), given.end());
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
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

/// Reads the bytes of the arrays in order; missing values are empty or 0.
class Reading {
  public:
    explicit Reading(std::string_view bytes) : rest_(bytes) {}

    std::string_view until(char end) {
        const std::size_t count = std::min(rest_.find(end), rest_.size());
        const std::string_view text = rest_.substr(0, count);
        rest_.remove_prefix(std::min(count + 1, rest_.size()));
        return text;
    }
    template <class Number>
    Number number(char end) {
        const std::string_view text = until(end);
        Number value{};
        std::from_chars(text.data(), text.data() + text.size(), value);
        return value;
    }
    /// All remaining bytes, if they are exactly `count` numbers.
    std::optional<std::vector<double>> numbers(std::uint64_t count) {
        if (rest_.size() % sizeof(double) != 0 || rest_.size() / sizeof(double) != count)
            return {};
        std::vector<double> values(count);
        std::memcpy(values.data(), rest_.data(), rest_.size());
        return values;
    }

  private:
    std::string_view rest_;
};

std::vector<stltsa::Joint> joints(Reading& from, std::uint64_t count) {
    std::vector<stltsa::Joint> all;
    for (std::uint64_t i = 0; i < count; ++i) {
        stltsa::Joint joint;
        joint.parent = from.number<std::int64_t>('\t');
        joint.is_end_site = from.number<int>('\t') != 0;
        for (double& offset : joint.offset)
            offset = from.number<double>('\t');
        joint.channels = std::string(from.until('\t'));
        joint.name = std::string(from.until('\n'));
        all.push_back(std::move(joint));
    }
    return all;
}

std::vector<std::string> names(Reading& from, std::uint64_t count) {
    std::vector<std::string> all;
    for (std::uint64_t i = 0; i < count; ++i)
        all.emplace_back(from.until('\n'));
    return all;
}

[[noreturn]] void no_clip(const std::string& file) {
    throw Failure(
        Exit::unreadable,
        fmt::format("{}: the Python package returned no clip (python3 -m stltsa.readers)", file));
}

stltsa::Clip whole_clip(const std::string& bytes, const std::string& file,
                        const stltsa::Options& options) {
    Reading from(bytes);
    const std::string_view kind = from.until(' ');
    const auto space = from.number<std::int32_t>(' ');
    const auto items = from.number<std::uint64_t>(' '), columns = from.number<std::uint64_t>(' '),
               frames = from.number<std::uint64_t>(' ');
    const auto fps = from.number<double>('\n');
    // Every item takes a line and every number takes bytes, so the counts have these limits.
    if (items > bytes.size() || columns == 0 || frames > bytes.size() / columns)
        no_clip(file);
    const bool skeleton = kind == "skeleton";
    const auto body = skeleton ? joints(from, items) : std::vector<stltsa::Joint>();
    const auto labels = skeleton ? std::vector<std::string>() : names(from, items);
    const auto values = from.numbers(columns * frames);
    if (!values)
        no_clip(file);
    const stltsa::MatrixView rows(*values, static_cast<std::int64_t>(columns));
    if (skeleton)
        return stltsa::Clip::from_skeleton(body, STLTSA_ROTATIONS_CHANNELS, rows, {}, fps);
    if (kind == "matrix")
        return stltsa::Clip::from_matrix(rows, fps);
    if (kind != "points")
        no_clip(file);
    return stltsa::Clip::from_points({rows, space, labels, {}, {}, fps}, options);
}

/// The output of the module. Throws Failure with the module's message if it fails.
std::string answer_to(const Words& given, const std::string& path) {
    const std::string python = python_interpreter();
    Pipe output;
    const pid_t child = start(python, given, output);
    output.close_end(1);
    std::string answer = read_all(output.ends[0]);
    const int status = wait_for(child);
    if (status == 127)
        cannot_run(python, ENOENT);
    if (status != 0)
        throw Failure(Exit::unreadable,
                      answer.empty() ? fmt::format("{}: the Python package failed", path) : answer);
    return answer;
}

} // namespace

bool is_foreign(const std::string& path) {
    return std::ranges::any_of(suffixes, [&](const char* suffix) { return ends_in(path, suffix); });
}

bool has_python() {
    return !python_interpreter().empty();
}

stltsa::Clip clip_of(const std::string& arrays, const std::string& path,
                     const stltsa::Options& options) {
    const std::string file = file_of(path);
    stltsa::Clip clip = whole_clip(arrays, file, options);
    clip.set_path(file);
    return file == path ? std::move(clip) : clip.stretch(path.substr(file.size() + 1), options);
}

std::optional<std::string> read_by_python(const std::string& path, const std::string& fps) {
    const std::string file = file_of(path);
    if (!has_python() || !is_foreign(file))
        return {};
    return answer_to({file, fps}, file);
}

std::string events_by_python(const std::string& path, const std::string& fps) {
    if (!has_python())
        throw Failure(Exit::unreadable,
                      fmt::format("{}: only the command that pip installs reads labels from "
                                  "C3D files: pip install 'stltsa[c3d]'",
                                  path));
    return answer_to({"--events", path, fps}, file_of(path));
}

} // namespace tool
