// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/help.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "arguments/choices.hpp"
#include "terminal/text.hpp"
#include "terminal/width.hpp"

namespace tool {

const char* const about = R"(Motion clips as low-dimensional curves, motion units and cycles.

Examples:
  stltsa decompose walk.bvh                        units and cycles, as a table
  stltsa decompose walk.bvh --json --plot walk.svg
  stltsa decompose markers.csv --fps 100 --features points
  stltsa decompose 35_01.amc --skeleton 35.asf
  stltsa fit walk.bvh -o walk.stltsa --dimension 3
  stltsa map walk.stltsa other.bvh -o y.npy        other frames, same curve
  stltsa unmap walk.stltsa y.npy -o poses.bvh      and back
  stltsa denoise walk.bvh -o cleaned.npy           the curve without noise
  stltsa synthesize walk.bvh --loop -o loop.bvh    a loop from its cycles
  stltsa batch recordings/ --out results           many clips
  stltsa compare before.bvh after.bvh              timing and amplitude, by phase
  stltsa events walk.bvh --mark 131=strike         the same event in every cycle
  stltsa live walk.stltsa other.bvh --json         the phase of a stream
  stltsa dimension walk.bvh
  stltsa info - < walk.bvh)";

const char* const ending =
    R"(Clips are BVH, AMC (with its ASF), CSV, TRC, MOT, C3D or NPY files; "-" is
standard input, and for an output standard output: tables as CSV, figures as
SVG, clips as BVH.
Exit status: 0 done, 1 failed, 2 usage, 3 unreadable input, 4 no trustworthy
result, 5 some clips of a batch failed, 130 cancelled.
See also: man stltsa, stltsa help COMMAND.)";

namespace {

constexpr const char* about_info = R"(Describes a clip.

Examples:
  stltsa info walk.bvh
  stltsa info 35_01.amc --json)";

constexpr const char* about_fit =
    R"(Fits the manifold curve (STLTSA) and reports its quality.

Examples:
  stltsa fit walk.bvh --coords y.csv
  stltsa fit walk.bvh --dimension 3 -o walk.stltsa
  stltsa fit walk.bvh --neighbors 1.2s --dimension 3 --coords y.npy
  stltsa fit walk.bvh --mode recurrent --links 4 --json)";

constexpr const char* about_map =
    R"(Places the frames of a clip on the curve of a model.

Examples:
  stltsa fit walk.bvh --dimension 3 -o walk.stltsa
  stltsa map walk.stltsa other.bvh -o y.npy
  stltsa map walk.stltsa other.bvh --json --curve)";

constexpr const char* about_unmap =
    R"(Turns points on the curve of a model into poses or frames.

A point becomes a frame. Give the number of points per second (--fps) unless
it is the rate of the model's samples.

Examples:
  stltsa unmap walk.stltsa y.npy -o poses.bvh
  stltsa unmap walk.stltsa y.npy --fps 120 -o poses.bvh
  stltsa unmap walk.stltsa y.csv -o frames.csv --follow)";

std::string about_synthesize() {
    const std::string piece =
        fmt::format("A piece is CLIP[:WHAT][*TIMES]. WHAT: frames (120-240), seconds (1.0s-2.0s), "
                    "a unit ({}), best or representative (cycle), cycleN; without it, the whole "
                    "clip.",
                    fmt::join(unit_names(), ", "));
    const char* const loop =
        "With --loop, a whole clip means the most consecutive cycles whose ends meet.";
    return "Joins pieces of clips into new motion.\n\n" + wrapped(piece, 78) + "\n" + loop + R"(

Examples:
  stltsa synthesize walk.bvh --loop -o loop.bvh
  stltsa synthesize 'walk.bvh:best*4' -o longer.bvh
  stltsa synthesize walk.bvh:initial 'walk.bvh:best*8' -o long.bvh
  stltsa synthesize walk.bvh run.bvh:cyclic -o joined.bvh)";
}

constexpr const char* about_dimension =
    R"(Estimates the intrinsic dimension: local PCA, and the eigengap.

Examples:
  stltsa dimension walk.bvh
  stltsa dimension walk.bvh --variance 0.99 --json)";

constexpr const char* about_denoise =
    R"(Cleans the curve: moves noisy points towards a smooth fit.

Examples:
  stltsa denoise walk.bvh --dimension 1
  stltsa denoise walk.stltsa -o cleaned.npy --curve-out curve.npy
  stltsa denoise y.csv --coordinates --fps 30 --gamma 0.01)";

constexpr const char* about_decompose = R"(Cuts a clip into motion units and cycles.

Examples:
  stltsa decompose walk.bvh
  stltsa decompose walk.bvh --json --plot walk.svg
  stltsa decompose walk.bvh:2.5s-9s -o units.csv
  stltsa decompose markers.csv --fps 100 --period-max 3
  stltsa decompose - < walk.bvh)";

constexpr const char* about_batch = R"(Decomposes many clips: one result each, and a summary.

The result of a/b.bvh is FOLDER/a__b.bvh.json. If a run was stopped, the next
one goes on from there: a result is kept if clip, options and version of the
library are the same.

Examples:
  stltsa batch recordings/ --out results
  stltsa batch *.bvh --out results --jobs 4 --period-max 3
  stltsa batch recordings/ --out results --shard 2/8)";

constexpr const char* about_compare =
    R"(Compares the cycles of two clips, or left and right of one.

The mean cycles are aligned by phase. For each joint, point or column that
both clips have, the answer says how much later in the cycle it moves, how
its amplitude differs, and how precisely this is known (95 % confidence
intervals). A * marks a difference whose interval excludes 0; by chance
alone, about one difference in 20 is marked.

Examples:
  stltsa compare before.bvh after.bvh
  stltsa compare walk.bvh                          left against right
  stltsa compare patient.csv model.csv --fps 100 --json
  stltsa compare walk.bvh:A walk.bvh:B -o differences.csv
  stltsa compare before.bvh after.bvh --report comparison.html)";

constexpr const char* about_events =
    R"(Finds a marked event in every cycle, and in other clips.

Examples:
  stltsa events walk.bvh --mark 131=left_strike --both-sides
  stltsa events walk.bvh --mark 131=strike --mark 2.5s=off -o events.csv
  stltsa events walk.bvh other.bvh --mark 131=strike --json)";

constexpr const char* about_live =
    R"(Plays a clip to a model as a stream, frame by frame.

The model must be of a clip that has cycles; the clip that is played must have
the same joints or points. The answer for a frame does not depend on the frames
after it.

Examples:
  stltsa fit walk.bvh --mark 131=strike -o walk.stltsa
  stltsa live walk.stltsa other.bvh --json)";

/// Width of the column of names. On narrow terminals, names stand above their texts.
constexpr std::size_t name_columns = 32;
constexpr std::size_t narrow_name_columns = 6;
constexpr std::size_t command_columns = 14;

/// Keeps an example command on its line, so that it can be copied; its description moves to the
/// next line if both do not fit.
std::string narrow_example(const std::string& line, std::size_t columns) {
    const std::size_t command = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t end = line.find("  ", command);
    if (characters(line) <= columns || end == line.npos)
        return line;
    return line.substr(0, end) + "\n      " + line.substr(line.find_first_not_of(' ', end));
}

/// Wraps the paragraphs that do not fit; indented lines are kept.
std::string narrow(const std::string& text, std::size_t columns) {
    std::string result, paragraph;
    bool fits = true;
    const auto close = [&] {
        std::string line = paragraph;
        std::ranges::replace(line, '\n', ' ');
        result += fits ? paragraph : wrapped(line, columns);
        paragraph.clear();
        fits = true;
    };
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with(' ')) {
            close();
            result += "\n" + narrow_example(line, columns);
            continue;
        }
        // The line feed before a paragraph is not part of it.
        if (paragraph.empty() && !result.empty())
            result += '\n';
        paragraph += (paragraph.empty() ? "" : "\n") + line;
        fits = fits && characters(line) <= columns;
    }
    close();
    return result;
}

/// Breaks long lists of names or choices after a comma or a bar.
std::string narrow_name(const std::string& name, std::size_t columns) {
    std::string result, line;
    for (std::size_t begin = 0; begin < name.size();) {
        const std::size_t end = std::min(name.find_first_of("|,", begin), name.size() - 1) + 1;
        const std::string part = name.substr(begin, end - begin);
        if (!line.empty() && characters(line + part) > columns) {
            result += line + "\n";
            line = "      ";
        }
        line += part;
        begin = end;
    }
    return result + line;
}

class HelpFormat : public CLI::Formatter {
  public:
    HelpFormat() { column_width(name_columns_); }

    std::string make_description(const CLI::App* app) const override {
        return narrow(app->get_description(), columns_) + "\n\n";
    }
    std::string make_usage(const CLI::App* app, std::string name) const override {
        return narrow(CLI::Formatter::make_usage(app, std::move(name)), columns_) + '\n';
    }
    std::string make_footer(const CLI::App* app) const override {
        return narrow(CLI::Formatter::make_footer(app), columns_) + '\n';
    }
    /// Examples belong to a command's own help, not to the list of commands.
    std::string make_subcommand(const CLI::App* command) const override {
        const std::string text = command->get_description();
        std::ostringstream out;
        CLI::detail::format_help(
            out, command->get_name(),
            wrapped(text.substr(0, text.find('\n')), columns_ - command_columns), command_columns);
        return out.str();
    }
    std::string make_option_name(const CLI::Option* option, bool positional) const override {
        const std::string name = CLI::Formatter::make_option_name(option, positional);
        return CLI::detail::find_and_replace(name, "{false}", "");
    }
    std::string make_option(const CLI::Option* option, bool positional) const override {
        const std::string name = make_option_name(option, positional) + make_option_opts(option);
        std::ostringstream out;
        CLI::detail::format_help(out, narrow_name(name, columns_ - 2), make_option_desc(option),
                                 name_columns_);
        return out.str();
    }
    std::string make_option_desc(const CLI::Option* option) const override {
        return wrapped(option->get_description(), columns_ - name_columns_);
    }
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override {
        return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
               in_groups(app) + make_subcommands(app, mode) + '\n' + make_footer(app);
    }

  private:
    std::string in_groups(const CLI::App* app) const {
        std::string text;
        for (const char* name : {group::output, group::input, group::method, group::messages}) {
            const auto options = app->get_options([name](const CLI::Option* option) {
                return option->get_group() == name && option->nonpositional();
            });
            if (!options.empty())
                text += make_group(name, false, options);
        }
        return text;
    }

    std::size_t columns_ = terminal_columns(STDOUT_FILENO);
    std::size_t name_columns_ = columns_ < 2 * name_columns ? narrow_name_columns : name_columns;
};

} // namespace

std::string about_command(Command command) {
    switch (command) {
    case Command::info:
        return about_info;
    case Command::fit:
        return about_fit;
    case Command::map:
        return about_map;
    case Command::unmap:
        return about_unmap;
    case Command::dimension:
        return about_dimension;
    case Command::decompose:
        return about_decompose;
    case Command::denoise:
        return about_denoise;
    case Command::synthesize:
        return about_synthesize();
    case Command::batch:
        return about_batch;
    case Command::compare:
        return about_compare;
    case Command::events:
        return about_events;
    case Command::live:
        return about_live;
    }
    return "";
}

std::shared_ptr<CLI::FormatterBase> help_format() {
    return std::make_shared<HelpFormat>();
}

} // namespace tool
