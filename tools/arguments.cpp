// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <stltsa.h>

#include "exit_status.hpp"
#include "option_flags.hpp"

namespace tool {
namespace {

constexpr const char* about = R"(Motion clips as low-dimensional curves, motion units and cycles.

Examples:
  stltsa decompose walk.bvh                        units and cycles, as a table
  stltsa decompose walk.bvh --json --plot walk.svg
  stltsa decompose markers.csv --fps 100 --features raw
  stltsa decompose 35_01.amc --skeleton 35.asf
  stltsa fit walk.bvh --coords y.npy --dimension 3
  stltsa dimension walk.bvh
  stltsa info - < walk.bvh)";

constexpr const char* ending =
    R"(Clips are BVH, AMC (with its ASF), CSV or NPY files; "-" is standard input.
Exit status: 0 done, 1 failed, 2 usage, 3 unreadable input, 4 no trustworthy
result, 130 cancelled. See also: man stltsa, stltsa COMMAND --help.)";

constexpr const char* about_info = R"(Says what is in a clip.

Examples:
  stltsa info walk.bvh
  stltsa info 35_01.amc --json)";

constexpr const char* about_fit =
    R"(Fits the manifold curve (STLTSA) and says how good it is.

Examples:
  stltsa fit walk.bvh --coords y.csv
  stltsa fit walk.bvh --neighbors 1.2s --dimension 3 --coords y.npy
  stltsa fit walk.bvh --mode recurrent --links 4 --json)";

constexpr const char* about_dimension =
    R"(Estimates the intrinsic dimension: local PCA, and the eigengap.

Examples:
  stltsa dimension walk.bvh
  stltsa dimension walk.bvh --variance 0.99 --json)";

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

using Keys = std::vector<std::int32_t>;
const Keys reading = {STLTSA_FPS, STLTSA_SKELETON};
const Keys preparing = {STLTSA_FEATURES,  STLTSA_UP_AXIS, STLTSA_KEEP_START,
                        STLTSA_SMOOTHING, STLTSA_RATE,    STLTSA_THREADS};
const Keys choosing = {STLTSA_NEIGHBORS, STLTSA_WINDOW,     STLTSA_DIMENSION,
                       STLTSA_MODE,      STLTSA_PERIOD_MIN, STLTSA_PERIOD_MAX};
const Keys graph = {STLTSA_INCLUDE_SELF, STLTSA_LINKS, STLTSA_EXCLUSION};
const Keys estimating = {STLTSA_EIGENGAP, STLTSA_VARIANCE};

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
                                                       STLTSA_VERSION_PATCH, stltsa_version()));
        app_.require_subcommand(1);
        add(Command::info, "info", about_info, {reading});
        CLI::App& fit = add(Command::fit, "fit", about_fit, {choosing, graph, preparing, reading});
        fit.add_option("--coords", to_.coords,
                       "Write the coordinates, rows x d, to a .npy or\n"
                       ".csv file.")
            ->type_name("FILE");
        add_plot(fit);
        CLI::App& dimension = add(Command::dimension, "dimension", about_dimension,
                                  {estimating, choosing, graph, preparing, reading});
        add_output(dimension);
        CLI::App& decompose =
            add(Command::decompose, "decompose", about_decompose, {choosing, preparing, reading});
        add_plot(decompose);
        add_output(decompose);
        decompose.add_flag("--curve", to_.curve,
                           "Add the curve and the loop, sample by sample, to\nthe JSON.");
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
            const auto chosen = app_.get_subcommands();
            throw Failure(Exit::usage,
                          fmt::format("{}\nTry 'stltsa {}--help'.", error.what(),
                                      chosen.empty() ? "" : chosen[0]->get_name() + " "));
        }
    }

  private:
    /// The parser itself would only say that a command is missing.
    void check_command(int argc, const char* const* argv) const {
        const std::string first = argc > 1 ? argv[1] : "";
        const auto named = [&](const CLI::App* command) { return command->get_name() == first; };
        if (first.starts_with('-') || std::ranges::any_of(app_.get_subcommands({}), named))
            return;
        throw Failure(Exit::usage, fmt::format("{}: give info, fit, dimension or decompose\n"
                                               "Try 'stltsa --help'.",
                                               argc > 1 ? "there is no command '" + first + "'"
                                                        : "a command is missing"));
    }

    CLI::App& add(Command command, const char* name, const char* text,
                  std::initializer_list<Keys> keys) {
        CLI::App& app = *app_.add_subcommand(name, text);
        app.add_option("clip", to_.input, "A clip, or - for standard input.")->required();
        app.add_flag("--json", to_.json, "Write one JSON object on one line.");
        app.add_flag("-q,--quiet", to_.quiet, "Say nothing on stderr but errors.");
        app.add_flag("--no-color", to_.no_color, "No colors, as with NO_COLOR set.");
        for (const Keys& group : keys)
            add_option_flags(app, group, to_.options);
        app.callback([this, command] { to_.command = command; });
        return app;
    }
    void add_output(CLI::App& app) {
        app.add_option("-o,--output", to_.output, "Write the result to a file.")->type_name("FILE");
    }
    void add_plot(CLI::App& app) {
        app.add_option("--plot", to_.plot, "Write a figure as SVG.")->type_name("FILE");
    }

    Arguments& to_;
    CLI::App app_;
};

/// A name without a suffix, as /dev/stdout, promises nothing.
bool has_other_suffix(const std::string& path, std::string_view suffix) {
    const std::size_t name = path.find_last_of('/') + 1; // npos + 1 is 0
    return path.find('.', name) != path.npos && !path.ends_with(suffix);
}

void check_arguments(const Arguments& arguments) {
    const std::string& coords = arguments.coords;
    if (!coords.empty() && !coords.ends_with(".npy") && !coords.ends_with(".csv"))
        throw Failure(Exit::usage,
                      fmt::format("--coords {}: the name must end in .npy or .csv", coords));
    if (!arguments.plot.empty() && has_other_suffix(arguments.plot, ".svg"))
        throw Failure(
            Exit::usage,
            fmt::format("--plot {}: figures are SVG: the name must end in .svg", arguments.plot));
    if (arguments.output.ends_with(".json") && !arguments.json)
        throw Failure(Exit::usage, fmt::format("--output {}: the result is a table for people; "
                                               "--json makes it JSON",
                                               arguments.output));
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
