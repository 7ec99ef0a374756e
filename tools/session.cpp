// SPDX-License-Identifier: BSD-3-Clause
#include "session.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "coords_file.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "option_flags.hpp"
#include "pieces.hpp"
#include "style.hpp"
#include "text.hpp"

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
    check(stltsa_options_get_real(options, STLTSA_OPT_RATE, &rate));
    const double fps = stltsa_clip_fps(clip);
    return rate > 0 ? fps / std::max(1.0, std::round(fps / rate)) : fps;
}

/// A file that cannot be written is no unreadable input.
void check_saving(stltsa_status status) {
    if (status == STLTSA_E_IO)
        throw Failure(Exit::failed, stltsa_last_error());
    check(status);
}

void save(const stltsa_clip* clip, const std::string& path) {
    check_saving(stltsa_clip_save(clip, path.c_str()));
}

/// The numbers of a table, for the library to write.
std::shared_ptr<stltsa_clip> bare_clip(const Grid& table) {
    const stltsa_in rows{table.values.data(), table.rows, table.cols, 0, 0, STLTSA_F64, 0};
    constexpr double any_rate = 1; // NPY has none
    stltsa_clip* clip = nullptr;
    check(stltsa_clip_from_matrix(&rows, any_rate, &clip));
    return {clip, stltsa_clip_free};
}

void check_outputs(const Arguments& arguments) {
    std::vector<std::string> taken{arguments.input, arguments.model};
    for (const std::string& piece : arguments.pieces)
        taken.push_back(parse_piece(piece).path);
    if (const auto skeleton = arguments.options.find(STLTSA_OPT_SKELETON);
        skeleton != arguments.options.end())
        taken.push_back(skeleton->second);
    for (const std::string& path : {arguments.output, arguments.plot, arguments.coords,
                                    arguments.product, arguments.curve_product}) {
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
}

void Session::set_default(std::int32_t key, std::int64_t value) {
    if (!arguments_.options.contains(key))
        check(stltsa_options_set_int(options_.get(), key, value));
}

const stltsa_clip* Session::open_input() {
    clip_ = open_clip(arguments_.input);
    set_lengths(options_.get(), arguments_.options, working_rate(clip(), options()));
    return clip();
}

Clip Session::open_clip(const std::string& path) const {
    stltsa_clip* clip = nullptr;
    if (path == "-") {
        const std::string& bytes = standard_input();
        check_reading(stltsa_clip_parse(bytes.data(), bytes.size(), 0, options(), &clip));
    } else {
        check_reading(stltsa_clip_open(path.c_str(), options(), &clip));
    }
    return Clip(clip);
}

Model Session::open_model(const std::string& path) const {
    stltsa_model* model = nullptr;
    if (path == "-") {
        const std::string& bytes = standard_input();
        check_reading(stltsa_model_parse(bytes.data(), bytes.size(), &model));
    } else {
        check_reading(stltsa_model_load(path.c_str(), &model));
    }
    return Model(model);
}

bool Session::input_is_model() const {
    if (arguments_.input == "-")
        return standard_input().starts_with("\x89STLTSA\n"); // docs/model-file.md
    return ends_in(arguments_.input, ".stltsa");
}

const std::string& Session::standard_input() const {
    if (!standard_input_)
        standard_input_ = read_stdin();
    return *standard_input_;
}

void Session::set_fps(double fps) {
    check(stltsa_options_set_real(options_.get(), STLTSA_OPT_FPS, fps));
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

void Session::add_table(const std::string& path, const Grid& table, const char* column) {
    if (!ends_in(path, ".npy"))
        return add_file(path, csv_text(table, column));
    files_.add_written(
        path, [clip = bare_clip(table)](const std::string& name) { save(clip.get(), name); });
}

void Session::add_clip(const std::string& path, const stltsa_clip* clip) {
    files_.add_written(path, [clip](const std::string& name) { save(clip, name); });
}

void Session::add_model(const std::string& path, const stltsa_model* model) {
    files_.add_written(path, [model](const std::string& name) {
        check_saving(stltsa_model_save(model, name.c_str()));
    });
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
