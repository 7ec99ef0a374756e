// SPDX-License-Identifier: BSD-3-Clause
#include "session.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "exit_status.hpp"
#include "interrupt.hpp"
#include "option_flags.hpp"
#include "style.hpp"

namespace tool {
namespace {

std::string read_stdin() {
    std::string bytes;
    char block[1 << 16];
    for (;;) {
        const ssize_t count = ::read(STDIN_FILENO, block, sizeof block);
        stop_if_interrupted();
        if (count == 0)
            return bytes;
        if (count > 0)
            bytes.append(block, static_cast<std::size_t>(count));
        else if (errno != EINTR)
            throw Failure(Exit::unreadable,
                          fmt::format("cannot read standard input: {}", std::strerror(errno)));
    }
}

/// Rate of the working samples: what lengths in seconds are counted in.
double working_rate(const stltsa_clip* clip, const stltsa_options* options) {
    double rate = 0;
    check(stltsa_options_get_real(options, STLTSA_RATE, &rate));
    const double fps = stltsa_clip_fps(clip);
    return rate > 0 ? fps / std::max(1.0, std::round(fps / rate)) : fps;
}

void check_outputs(const Arguments& arguments) {
    std::vector<std::string> taken{arguments.input};
    if (const auto skeleton = arguments.options.find(STLTSA_SKELETON);
        skeleton != arguments.options.end())
        taken.push_back(skeleton->second);
    for (const std::string& path : {arguments.output, arguments.plot, arguments.coords}) {
        if (path.empty())
            continue;
        check_output_place(path, taken);
        taken.push_back(path);
    }
}

} // namespace

Session::Session(const Arguments& arguments)
    : arguments_(arguments), bar_(!arguments.quiet && ::isatty(STDERR_FILENO) != 0),
      options_(made_by<Options>(stltsa_options_new)) {
    check_outputs(arguments);
    check(stltsa_options_set_progress(options_.get(), ProgressBar::callback, &bar_));
    set_options(options_.get(), arguments.options);
    read_clip();
    set_lengths(options_.get(), arguments.options, working_rate(clip(), options()));
}

void Session::read_clip() {
    stltsa_clip* clip = nullptr;
    if (arguments_.input == "-") {
        const std::string bytes = read_stdin();
        check_reading(stltsa_clip_parse(bytes.data(), bytes.size(), 0, options(), &clip));
    } else {
        check_reading(stltsa_clip_open(arguments_.input.c_str(), options(), &clip));
    }
    clip_.reset(clip);
}

std::string Session::title() const {
    if (arguments_.input == "-")
        return "standard input";
    return std::filesystem::path(arguments_.input).filename().string();
}

bool Session::colors() const {
    return arguments_.output.empty() && colors_wanted(STDOUT_FILENO, !arguments_.no_color);
}

void Session::add_file(const std::string& path, std::string content) {
    files_.add(path, std::move(content));
}

/// Warnings are part of the table; where it is not what the user sees, they go to stderr too.
void Session::warn(const Json& object) const {
    const bool seen = !arguments_.json && arguments_.output.empty();
    if (arguments_.quiet || seen || !object.contains("warnings"))
        return;
    for (const Json& warning : object["warnings"])
        print_message("warning: " + with_flags(warning.get<std::string>()), Tone::warning,
                      !arguments_.no_color);
}

void Session::finish(const Json& object, const std::string& table) {
    stop_if_interrupted();
    bar_.clear();
    const std::string text = arguments_.json ? object.dump() + "\n" : table;
    if (arguments_.output.empty())
        write_stdout(text);
    else
        files_.add(arguments_.output, text);
    files_.commit();
    warn(object);
}

} // namespace tool
