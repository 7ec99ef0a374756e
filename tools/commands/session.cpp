// SPDX-License-Identifier: BSD-3-Clause
#include "commands/session.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "arguments/option_flags.hpp"
#include "arguments/pieces.hpp"
#include "base/npy_bytes.hpp"
#include "clip/files/descriptor.hpp"
#include "commands/coords_file.hpp"
#include "exit_status.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

std::string read_stdin() {
    std::string bytes;
    char block[1 << 16];
    try {
        while (const auto count = stltsa::clip::read_some(STDIN_FILENO, block)) {
            stop_if_interrupted();
            bytes.append(block, count);
        }
        return bytes;
    } catch (const std::system_error& error) {
        throw Failure(Exit::unreadable,
                      fmt::format("cannot read standard input: {}", error.code().message()));
    }
}

/// Calls `write`; an error of writing does not count as an unreadable input.
template <class Write>
void writing(Write write) {
    try {
        write();
    } catch (const stltsa::Error& error) {
        throw error.status() == STLTSA_E_IO ? Failure(Exit::failed, error.what()) : Failure(error);
    }
}

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Calls `read`; its errors count as an unreadable input.
template <class Read>
auto reading(Read read) {
    try {
        return read();
    } catch (const stltsa::Error& error) {
        throw unreadable(error);
    }
}

/// Calls `read` for the bytes of standard input, for which the library has no name or "memory".
template <class Read>
auto reading_stdin(Read read) {
    constexpr std::string_view memory = "memory:";
    return reading([&] {
        try {
            return read();
        } catch (const stltsa::Error& error) {
            const std::string text = error.what();
            throw stltsa::Error(error.status(), text.starts_with(memory)
                                                    ? "standard input:" + text.substr(memory.size())
                                                    : "standard input: " + text);
        }
    });
}

void check_outputs(const Arguments& arguments) {
    std::vector<std::string> taken{file_of(arguments.input), arguments.model};
    for (const std::string& piece : arguments.pieces)
        taken.push_back(parse_piece(piece).path);
    if (const auto skeleton = arguments.options.find(STLTSA_OPT_SKELETON);
        skeleton != arguments.options.end())
        taken.push_back(skeleton->second);
    std::vector<std::string> places = arguments.products();
    places.insert(places.begin(), arguments.output);
    for (const std::string& path : places) {
        if (path.empty() || path == standard_output)
            continue;
        check_output_place(path, taken);
        taken.push_back(path);
    }
}

} // namespace

double working_rate(const stltsa::Clip& clip, const stltsa::Options& options) {
    const double rate = options.real(STLTSA_OPT_SAMPLE_RATE);
    return rate > 0 ? clip.fps() / std::max(1.0, std::round(clip.fps() / rate)) : clip.fps();
}

Session::Session(const Arguments& arguments)
    : arguments_(arguments), bar_(!arguments.quiet && obeys_codes(STDERR_FILENO)) {
    check_outputs(arguments);
    options_.set_progress([this](std::int32_t stage, double fraction) {
        bar_.show(stage, fraction);
        return interrupted();
    });
    set_options(options_, arguments.options);
}

void Session::set_default(std::int32_t key, std::int64_t value) {
    if (!options_.is_set(key))
        options_.set(key, value);
}

const stltsa::Clip& Session::open_input() {
    clip_ = open_clip(arguments_.input);
    set_lengths(options_, arguments_.options, working_rate(clip(), options()));
    return clip();
}

stltsa::Clip Session::open_clip(const std::string& path) const {
    if (is_standard_input(path))
        return parse_stdin(path.substr(std::min<std::size_t>(path.size(), 2))); // after "-:"
    return reading([&] { return stltsa::Clip::open_stretch(path, options()); });
}

/// `what`: a stretch; empty: the whole clip.
stltsa::Clip Session::parse_stdin(const std::string& what) const {
    return reading_stdin([&] {
        stltsa::Clip clip =
            stltsa::Clip::parse(std::as_bytes(std::span(standard_input())), 0, options());
        return what.empty() ? std::move(clip) : clip.stretch(what, options());
    });
}

stltsa::Model Session::open_model(const std::string& path) const {
    if (path != "-")
        return reading([&] { return stltsa::Model::load(path); });
    return reading_stdin(
        [&] { return stltsa::Model::parse(std::as_bytes(std::span(standard_input()))); });
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
    if (fps > 0)
        options_.set(STLTSA_OPT_FPS, fps);
}

std::string Session::title() const {
    return title_of(arguments_.input);
}

std::string Session::title_of(const std::string& path) {
    return one_line(is_standard_input(path) ? "standard input" + path.substr(1)
                                            : std::filesystem::path(path).filename().string());
}

void Session::add_file(const std::string& path, std::string content) {
    files_.add(path, std::move(content));
}

void Session::add_table(const std::string& path, const stltsa::Matrix& table, const char* column,
                        double fps) {
    add_file(path, ends_in(path, ".npy")
                       ? stltsa::npy_bytes(table.values.data(), table.rows, table.cols)
                       : csv_text(table, column, fps));
}

void Session::add_columns(const std::string& path, const stltsa::Matrix& table,
                          const std::vector<const char*>& names) {
    if (ends_in(path, ".npy"))
        return add_table(path, table);
    std::string text = fmt::format("{}\n", fmt::join(names, ","));
    for (std::int64_t r = 0; r < table.rows; ++r)
        for (std::int64_t c = 0; c < table.cols; ++c) {
            const double value = table(r, c);
            if (!std::isnan(value)) // a missing value is an empty cell
                text += fmt::format("{}", value);
            text += c + 1 < table.cols ? ',' : '\n';
        }
    add_file(path, std::move(text));
}

void Session::add_clip(const std::string& path, const stltsa::Clip& clip) {
    const std::string suffix =
        path == standard_output ? ".bvh" : std::filesystem::path(path).extension().string();
    files_.add_written(path, suffix, [this, path, &clip](const std::string& name) {
        writing([&] { clip.save(name, options_); });
        if (ends_in(path, ".amc") && name != path)
            add_skeleton(name, path);
    });
}

/// The library wrote the skeleton beside the temporary file.
void Session::add_skeleton(const std::string& temporary, const std::string& amc) {
    std::filesystem::path written = temporary, place = amc;
    const std::string text = file_text(written.replace_extension(".asf"));
    std::error_code none;
    std::filesystem::remove(written, none);
    if (!std::filesystem::exists(place.replace_extension(".asf"), none))
        files_.add(place.string(), text);
    else if (file_text(place) != text)
        throw Failure(Exit::failed,
                      fmt::format("{}: exists and is another skeleton, but that of {} would be "
                                  "written there: choose another name for the clip",
                                  place.string(), amc));
}

void Session::add_model(const std::string& path, const stltsa::Model& model) {
    files_.add_written(path, ".stltsa",
                       [&model](const std::string& name) { writing([&] { model.save(name); }); });
}

void Session::add_saved(const std::string& path, const char* suffix,
                        std::function<void(const std::string&)> save) {
    files_.add_written(path, suffix, [save = std::move(save)](const std::string& name) {
        writing([&] { save(name); });
    });
}

bool Session::table_is_seen() const {
    return !arguments_.json && text_place() == standard_output;
}

std::string Session::text_place() const {
    if (!arguments_.output.empty())
        return arguments_.output;
    return stdout_is_taken(arguments_) ? "" : std::string(standard_output);
}

/// Warnings and notes are part of the table; if the user does not see it, they go to stderr.
void Session::tell(const std::vector<std::string>& texts, const char* kind) const {
    if (arguments_.quiet || table_is_seen())
        return;
    for (const std::string& text : texts)
        print_message(fmt::format("{}: {}", kind, with_flags(text)), Tone::warning,
                      !arguments_.no_color);
}

std::string Session::text_of(const Answer& answer) const {
    const bool colors =
        text_place() == standard_output && colors_wanted(STDOUT_FILENO, !arguments_.no_color);
    if (arguments_.json)
        return answer.json() + '\n';
    if (!ends_in(arguments_.output, ".csv"))
        return shown(answer.table(), colors);
    if (!answer.csv)
        throw Failure(Exit::usage, fmt::format("-o {}: there is no CSV of this result: use .json "
                                               "or .txt",
                                               arguments_.output));
    return answer.csv();
}

void Session::finish(const Answer& answer) {
    if (const std::string place = text_place(); !place.empty())
        files_.add(place, text_of(answer));
    stop_if_interrupted();
    bar_.clear();
    files_.commit();
    tell(answer.warnings, "warning");
    tell(answer.notes, "note");
}

} // namespace tool
