// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/arguments.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stltsa.hpp>

#include "arguments/choices.hpp"
#include "arguments/option_flags.hpp"
#include "exit_status.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

constexpr const char* about = R"(Motion clips as low-dimensional curves, motion units and cycles.

Examples:
  stltsa decompose walk.bvh                        units and cycles, as a table
  stltsa decompose walk.bvh --json --plot walk.svg
  stltsa decompose markers.csv --fps 100 --features points
  stltsa decompose 35_01.amc --skeleton 35.asf
  stltsa fit walk.bvh -o walk.stltsa --dimension 3
  stltsa map walk.stltsa other.bvh -o y.npy        other frames, same curve
  stltsa unmap walk.stltsa y.npy -o poses.bvh      and back
  stltsa denoise walk.bvh --plot before_after.svg  the curve without noise
  stltsa synthesize walk.bvh --loop -o loop.bvh    a loop from its cycles
  stltsa dimension walk.bvh
  stltsa info - < walk.bvh)";

constexpr const char* ending =
    R"(Clips are BVH, AMC (with its ASF), CSV or NPY files; "-" is standard input.
Exit status: 0 done, 1 failed, 2 usage, 3 unreadable input, 4 no trustworthy
result, 130 cancelled. See also: man stltsa, stltsa COMMAND --help.)";

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
        "With --loop, a whole clip means the most of its cycles whose ends meet.";
    return "Joins pieces of clips into new motion.\n\n" + wrapped(piece, 78) + "\n" + loop + R"(

Examples:
  stltsa synthesize walk.bvh --loop -o loop.bvh
  stltsa synthesize 'walk.bvh:best*4' -o longer.bvh
  stltsa synthesize walk.bvh:initial 'walk.bvh:best*8' -o long.bvh
  stltsa synthesize walk.bvh run.bvh:cyclic -o joined.bvh --plot seams.svg)";
}

constexpr const char* about_dimension =
    R"(Estimates the intrinsic dimension: local PCA, and the eigengap.

Examples:
  stltsa dimension walk.bvh
  stltsa dimension walk.bvh --variance 0.99 --json)";

constexpr const char* about_denoise =
    R"(Cleans the curve: moves noisy points towards a smooth fit.

Examples:
  stltsa denoise walk.bvh --dimension 1 --plot before_after.svg
  stltsa denoise walk.stltsa -o cleaned.npy --curve-out curve.npy
  stltsa denoise y.csv --coordinates --fps 30 --gamma 0.01)";

constexpr const char* about_decompose = R"(Cuts a clip into motion units and cycles.

Examples:
  stltsa decompose walk.bvh
  stltsa decompose walk.bvh --json --plot walk.svg
  stltsa decompose markers.csv --fps 100 --period-max 3
  stltsa decompose - < walk.bvh)";

/// Examples belong to a command's own help, not to the list of commands.
class HelpFormat : public CLI::Formatter {
  public:
    std::string make_description(const CLI::App* app) const override {
        return app->get_description() + "\n\n";
    }
    std::string make_subcommand(const CLI::App* command) const override {
        const std::string text = command->get_description();
        std::ostringstream out;
        constexpr std::size_t name_columns = 14;
        CLI::detail::format_help(out, command->get_name(), text.substr(0, text.find('\n')),
                                 name_columns);
        return out.str();
    }
    std::string make_option_name(const CLI::Option* option, bool positional) const override {
        const std::string name = CLI::Formatter::make_option_name(option, positional);
        return CLI::detail::find_and_replace(name, "{false}", "");
    }
};

/// The functions that a command calls, whose options it has.
std::int32_t calls_of(Command command) {
    switch (command) {
    case Command::info:
        return STLTSA_CALL_OPEN;
    case Command::fit:
        return STLTSA_CALL_OPEN | STLTSA_CALL_FIT;
    case Command::map:
        return STLTSA_CALL_OPEN | STLTSA_CALL_MAP;
    case Command::unmap:
        return STLTSA_CALL_UNMAP;
    case Command::dimension:
        return STLTSA_CALL_OPEN | STLTSA_CALL_DIMENSION;
    case Command::decompose:
        return STLTSA_CALL_OPEN | STLTSA_CALL_DECOMPOSE;
    case Command::denoise:
        return STLTSA_CALL_OPEN | STLTSA_CALL_FIT | STLTSA_CALL_DENOISE;
    case Command::synthesize:
        return STLTSA_CALL_OPEN | STLTSA_CALL_SYNTHESIZE;
    }
    return 0;
}

/// Exceptions: map gives no hints, and denoise saves no model; synthesize decomposes clips of which
/// it takes units.
bool has_option(Command command, const stltsa::OptionInfo& option) {
    if (command == Command::map && option.key == STLTSA_OPT_HINT_WINDOW)
        return false;
    if (command == Command::denoise && option.key == STLTSA_OPT_KEEP_FRAMES)
        return false;
    if (command == Command::synthesize &&
        (option.key == STLTSA_OPT_PERIOD_MIN || option.key == STLTSA_OPT_PERIOD_MAX))
        return true;
    return (option.calls & calls_of(command)) != 0;
}

/// The text of an option, without what it does in other commands.
std::string text_of(Command command, const stltsa::OptionInfo& option) {
    if (option.key == STLTSA_OPT_DIMENSION)
        return command == Command::decompose
                   ? "Tangent dimension (d); auto: the best of 1 to 3."
                   : "Tangent dimension, the number of coordinates (d); auto: 2.";
    if (option.key == STLTSA_OPT_FPS)
        return command == Command::unmap
                   ? "Points per second; auto: the rate of the coordinates, or the model's."
                   : "Frames per second; auto: the file's rate.";
    return option.text;
}

/// Builds the parser; what it reads goes into `to`.
class Parser {
  public:
    explicit Parser(Arguments& to) : to_(to), app_(about, "stltsa") {
        const auto format = std::make_shared<HelpFormat>();
        format->column_width(32);
        app_.formatter(format);
        app_.footer(ending);
        app_.set_version_flag("--version", fmt::format("stltsa {}.{}.{} (libstltsa {})",
                                                       STLTSA_VERSION_MAJOR, STLTSA_VERSION_MINOR,
                                                       STLTSA_VERSION_PATCH, stltsa::version()));
        app_.require_subcommand(1);
        const char* const a_clip = "A clip, or - for standard input.";
        clip_command(Command::info, "info", about_info, a_clip);
        CLI::App& fit = clip_command(Command::fit, "fit", about_fit, a_clip);
        fit.add_option("--coords", to_.coords,
                       "Write the coordinates, rows x d, to a .npy or\n"
                       ".csv file.")
            ->type_name("FILE");
        add_product(fit, "Write the model (.stltsa), for map, unmap and\ndenoise.");
        add_plot(fit);
        CLI::App& map = model_command(Command::map, "map", about_map, a_clip);
        add_product(map, "Write the coordinates to a .npy or .csv file.");
        map.add_flag("--curve", to_.curve,
                     "Add coordinates, distances and nearest rows of\nall frames to the JSON.");
        CLI::App& unmap = model_command(Command::unmap, "unmap", about_unmap,
                                        "Coordinates: a CSV or NPY file, or - .");
        add_product(unmap, "Write poses (.bvh, .amc) or frames (.npy, .csv).")->required();
        unmap.add_flag("--follow", to_.follow,
                       "Continue from the previous point, for\n"
                       "coordinates that do not determine the pose\n"
                       "alone. Sets --hint-window to 2 unless given.");
        CLI::App& dimension =
            clip_command(Command::dimension, "dimension", about_dimension, a_clip);
        add_output(dimension);
        CLI::App& decompose =
            clip_command(Command::decompose, "decompose", about_decompose, a_clip);
        add_plot(decompose);
        add_output(decompose);
        decompose.add_flag("--curve", to_.curve,
                           "Add the curve and the loop, sample by sample, to\nthe JSON.");
        add_denoise();
        CLI::App& synthesize = add(Command::synthesize, "synthesize", about_synthesize());
        synthesize.add_option("pieces", to_.pieces, "Pieces, in the order of the new motion.")
            ->required();
        add_product(synthesize, "Write the new motion to a .bvh, .amc, .csv or\n.npy file.")
            ->required();
        add_plot(synthesize);
    }

    void parse(int argc, const char* const* argv) {
        check_command(argc, argv);
        try {
            app_.parse(argc, argv);
        } catch (const CLI::CallForHelp&) {
            to_.answer = app_.help();
        } catch (const CLI::CallForVersion& version) {
            to_.answer = fmt::format("{}\n", version.what());
        } catch (const CLI::ParseError& error) {
            const CLI::App* chosen =
                app_.get_subcommands().empty() ? nullptr : app_.get_subcommands()[0];
            throw Failure(Exit::usage,
                          fmt::format("{}{}\nTry 'stltsa {}--help'.", error.what(),
                                      chosen == nullptr ? "" : option_hint(*chosen),
                                      chosen == nullptr ? "" : chosen->get_name() + " "));
        }
    }

  private:
    /// For the first flag that the command does not have, one that it has.
    static std::string option_hint(const CLI::App& command) {
        std::vector<std::string> flags;
        for (const CLI::Option* option : command.get_options())
            for (const std::string& name : option->get_lnames())
                flags.push_back("--" + name);
        for (const std::string& word : command.remaining())
            if (word.starts_with("--"))
                return hint(word.substr(0, word.find('=')), flags);
        return "";
    }

    /// The parser itself would only say that a command is missing.
    void check_command(int argc, const char* const* argv) const {
        const std::string first = argc > 1 ? argv[1] : "";
        std::vector<std::string> names;
        for (const CLI::App* command : app_.get_subcommands({}))
            names.push_back(command->get_name());
        if (first.starts_with('-') || std::ranges::find(names, first) != names.end())
            return;
        const std::string what =
            argc > 1 ? "there is no command '" + first + "'" : "a command is missing";
        throw Failure(Exit::usage, fmt::format("{}: give one of {}{}\nTry 'stltsa --help'.", what,
                                               fmt::join(names, ", "), hint(first, names)));
    }

    CLI::App& add(Command command, const char* name, const std::string& text) {
        CLI::App& app = *app_.add_subcommand(name, text);
        app.add_flag("--json", to_.json, "Write one JSON object on one line.");
        app.add_flag("-q,--quiet", to_.quiet, "Write only errors to standard error.");
        app.add_flag("--no-color", to_.no_color, "No colors, as with NO_COLOR set.");
        for (const stltsa::OptionInfo& option : stltsa::option_table())
            if (has_option(command, option))
                add_option_flag(app, option, text_of(command, option), to_.options);
        app.callback([this, command] { to_.command = command; });
        return app;
    }
    CLI::App& clip_command(Command command, const char* name, const char* text, const char* input) {
        CLI::App& app = add(command, name, text);
        app.add_option("clip", to_.input, input)->required();
        return app;
    }
    CLI::App& model_command(Command command, const char* name, const char* text,
                            const char* input) {
        CLI::App& app = add(command, name, text);
        app.add_option("model", to_.model, "A model that stltsa fit -o wrote, or -.")->required();
        app.add_option(command == Command::map ? "clip" : "coords", to_.input, input)->required();
        return app;
    }
    void add_denoise() {
        CLI::App& denoise = clip_command(Command::denoise, "denoise", about_denoise,
                                         "A model (.stltsa), a clip, or - for either.");
        denoise.add_flag("--coordinates", to_.coordinates,
                         "The columns of the CSV or NPY file are\ncoordinates: do not fit.");
        add_product(denoise, "Write the cleaned coordinates to a .npy or .csv\nfile.");
        denoise
            .add_option("--curve-out", to_.curve_product,
                        "Write the fitted curve to a .npy or .csv file.")
            ->type_name("FILE");
        add_plot(denoise);
        denoise.add_flag("--curve", to_.curve,
                         "Add coordinates, curve and cleaned coordinates,\nrow by row, to the "
                         "JSON.");
    }
    CLI::Option* add_product(CLI::App& app, const char* text) {
        return app.add_option("-o,--output", to_.product, text)->type_name("FILE");
    }
    void add_output(CLI::App& app) {
        app.add_option("-o,--output", to_.output, "Write the result to a file; -: standard output.")
            ->type_name("FILE");
    }
    void add_plot(CLI::App& app) {
        app.add_option("--plot", to_.plot, "Write a figure as SVG.")->type_name("FILE");
    }

    Arguments& to_;
    CLI::App app_;
};

void check_suffix(const char* flag, const std::string& path,
                  std::initializer_list<std::string_view> suffixes) {
    if (path.empty() || std::ranges::any_of(suffixes, [&](std::string_view suffix) {
            return ends_in(path, suffix);
        }))
        return;
    throw Failure(Exit::usage, fmt::format("{} {}: the name must end in {}", flag, path,
                                           fmt::join(suffixes, ", ")));
}

/// A name without a suffix, as /dev/stdout, promises nothing.
bool has_suffix(const std::string& path) {
    return path.find('.', path.find_last_of('/') + 1) != path.npos; // npos + 1 is 0
}

void check_arguments(const Arguments& arguments) {
    check_suffix("--coords", arguments.coords, {".npy", ".csv"});
    if (arguments.command == Command::fit)
        check_suffix("-o", arguments.product, {".stltsa"});
    check_suffix("--curve-out", arguments.curve_product, {".npy", ".csv"});
    if (arguments.command == Command::map || arguments.command == Command::denoise)
        check_suffix("-o", arguments.product, {".npy", ".csv"});
    if (arguments.command == Command::unmap || arguments.command == Command::synthesize)
        check_suffix("-o", arguments.product, {".bvh", ".amc", ".npy", ".csv"});
    if (has_suffix(arguments.plot))
        check_suffix("--plot", arguments.plot, {".svg"});
    if (arguments.command == Command::decompose && has_suffix(arguments.output))
        check_suffix("-o", arguments.output, {".csv", ".json", ".txt"});
    if (ends_in(arguments.output, ".csv") && arguments.json)
        throw Failure(
            Exit::usage,
            fmt::format("--output {}: JSON goes to a file that ends in .json", arguments.output));
    if (ends_in(arguments.output, ".json") && !arguments.json)
        throw Failure(Exit::usage, fmt::format("--output {}: the result is a table for people; "
                                               "--json makes it JSON",
                                               arguments.output));
    if (arguments.command == Command::unmap && !arguments.follow &&
        arguments.options.contains(STLTSA_OPT_HINT_WINDOW))
        throw Failure(Exit::usage, "--hint-window goes with --follow");
    if (arguments.model == "-" && arguments.input == "-")
        throw Failure(Exit::usage, "standard input (-) is one file: the model or the other");
    if (arguments.curve && !arguments.json)
        throw Failure(Exit::usage, "--curve goes with --json");
}

} // namespace

Arguments parse_arguments(int argc, const char* const* argv) {
    Arguments arguments;
    Parser parser(arguments);
    parser.parse(argc, argv);
    if (arguments.answer.empty())
        check_arguments(arguments);
    return arguments;
}

} // namespace tool
