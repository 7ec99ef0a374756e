// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/output.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "exit_status.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

namespace fs = std::filesystem;
using stltsa::clip::followed;
using stltsa::clip::regular_or_new;
using stltsa::clip::TemporaryFile;
using stltsa::clip::why_not_written;
using stltsa::clip::write_all;
using stltsa::clip::write_directly;

constexpr const char* stdout_name = "standard output";

[[noreturn]] void fail_writing(const std::string& name, const std::error_code& error) {
    throw Failure(Exit::failed,
                  fmt::format("cannot write {}: {}", one_line(name), why_not_written(error)));
}

/// Calls `write`; its errors name the destination as given.
template <class Write>
auto writing(const std::string& name, Write write) {
    try {
        return write();
    } catch (const std::system_error& error) {
        fail_writing(name, error.code());
    }
}

std::string content_of(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Calls `write` for a temporary file; the user knows it as `path`.
void write_named(const OutputFiles::Write& write, const std::string& temporary,
                 const std::string& path) {
    try {
        write(temporary);
    } catch (const Failure& failure) {
        std::string text = failure.what();
        if (text.starts_with(temporary))
            text.replace(0, temporary.size(), path);
        throw Failure(failure.status(), std::move(text));
    }
}

TemporaryFile temporary_for_stdout(const std::string& suffix) {
    try {
        return TemporaryFile((fs::temp_directory_path() / "stdout").string(), suffix);
    } catch (const std::system_error& error) {
        throw Failure(Exit::failed,
                      fmt::format("cannot write a temporary file: {}: set TMPDIR to a "
                                  "folder in which you may write",
                                  error.code().message()));
    }
}

/// Whether both paths name one file, existing or new. Several results may go to /dev/null.
bool same_place(const std::string& path, const std::string& other) {
    std::error_code none;
    const auto place_of = [&none](const std::string& name) {
        return fs::weakly_canonical(fs::absolute(followed(name), none), none);
    };
    return regular_or_new(path) && place_of(path) == place_of(other);
}

} // namespace

void write_stdout(std::string_view text) {
    writing(stdout_name, [&] { write_all(STDOUT_FILENO, text); });
}

void OutputFiles::add_to_stdout(std::string content) {
    staged_.push_back(
        {stdout_name, {}, [text = std::move(content)] { write_all(STDOUT_FILENO, text); }});
}

void OutputFiles::add(const std::string& path, std::string content) {
    if (path == standard_output)
        return add_to_stdout(std::move(content));
    const std::string place = followed(path);
    if (!regular_or_new(place)) {
        staged_.push_back({path, {}, [place, text = std::move(content)] {
                               write_directly(place, [&](const auto& sink) { sink(text); });
                           }});
        return;
    }
    writing(path, [&] {
        TemporaryFile file(place);
        file.write([&](const auto& sink) { sink(content); });
        staged_.push_back({path, std::move(file), {}});
    });
}

void OutputFiles::add_written(const std::string& path, const std::string& suffix,
                              const Write& write) {
    const std::string place = followed(path);
    const bool special = path != standard_output && !regular_or_new(place);
    if (path == standard_output || (special && !ends_in(path, suffix))) { // `write` needs a name
        const TemporaryFile file = temporary_for_stdout(suffix);
        write_named(write, file.name(), stdout_name);
        std::string content = content_of(file.name());
        if (special)
            return add(path, std::move(content));
        // A terminal would obey codes in the names of a clip.
        return add_to_stdout(::isatty(STDOUT_FILENO) != 0 ? shown(content, false)
                                                          : std::move(content));
    }
    if (special) {
        staged_.push_back(
            {path, {}, [path, write] { write(path); }}); // not `place`: the link has the suffix
        return;
    }
    TemporaryFile file = writing(path, [&] { return TemporaryFile(place, suffix); });
    write_named(write, file.name(), path);
    staged_.push_back({path, std::move(file), {}});
}

void OutputFiles::commit() {
    for (const Staged& file : staged_)
        if (!file.temporary)
            writing(file.name, file.write);
    for (Staged& file : staged_)
        if (file.temporary)
            writing(file.name, [&] { file.temporary->move_to_place(); });
    staged_.clear();
}

void check_output_place(const std::string& path, const std::vector<std::string>& taken) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status))
        error = std::make_error_code(std::errc::is_a_directory);
    if (!fs::status_known(status) || fs::is_directory(status))
        fail_writing(path, error);
    for (const std::string& other : taken)
        if (same_place(path, other))
            throw Failure(Exit::usage,
                          fmt::format("{} is an input, or is given for two outputs", path));
    const fs::path place = followed(path);
    if (!regular_or_new(place.string()))
        return;
    const std::string folder = place.has_parent_path() ? place.parent_path().string() : ".";
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        fail_writing(path, std::error_code(errno, std::generic_category()));
}

} // namespace tool
