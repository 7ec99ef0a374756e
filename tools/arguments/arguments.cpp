// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/arguments.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stltsa.hpp>

#include "arguments/checks.hpp"
#include "arguments/completions.hpp"
#include "arguments/help.hpp"
#include "arguments/option_flags.hpp"
#include "arguments/pieces.hpp"
#include "exit_status.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

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
        return STLTSA_CALL_OPEN | STLTSA_CALL_FIT;
    case Command::decompose:
    case Command::batch:
    case Command::compare:
    case Command::events:
        return STLTSA_CALL_OPEN | STLTSA_CALL_DECOMPOSE;
    case Command::denoise:
        return STLTSA_CALL_OPEN | STLTSA_CALL_FIT | STLTSA_CALL_DENOISE;
    case Command::synthesize:
        return STLTSA_CALL_OPEN | STLTSA_CALL_SYNTHESIZE;
    case Command::live:
        return STLTSA_CALL_OPEN;
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
    if (command == Command::batch && option.key == STLTSA_OPT_THREADS)
        return false; // --jobs
    if (command == Command::synthesize &&
        (option.key == STLTSA_OPT_PERIOD_MIN || option.key == STLTSA_OPT_PERIOD_MAX))
        return true;
    return (option.calls & calls_of(command)) != 0;
}

/// The text of an option, without what it does in other commands.
std::string text_of(Command command, const stltsa::OptionInfo& option) {
    if (option.key == STLTSA_OPT_FPS)
        return command == Command::unmap
                   ? "Points per second; auto: the rate of the coordinates, or the model's."
                   : "Frames per second; auto: the file's rate.";
    return option.text;
}

const char* group_of(const stltsa::OptionInfo& option) {
    switch (option.key) {
    case STLTSA_OPT_FPS:
    case STLTSA_OPT_SKELETON:
    case STLTSA_OPT_SUBJECT:
    case STLTSA_OPT_MIN_CONFIDENCE:
    case STLTSA_OPT_GAPS:
    case STLTSA_OPT_FEATURES:
    case STLTSA_OPT_UP_AXIS:
    case STLTSA_OPT_KEEP_START:
    case STLTSA_OPT_SAMPLE_RATE:
    case STLTSA_OPT_SMOOTHING:
        return group::input;
    default:
        return group::method;
    }
}

/// The name of a file, or of none that is there.
bool looks_like_a_path(const std::string& word) {
    return word.find_first_of("./:") != word.npos;
}

// CLI11 would take a stretch of standard input, "-:cyclic", for an option.
constexpr char shield = '\x01';

void shield_stretches(std::vector<std::string>& words) {
    for (std::string& word : words)
        if (word.starts_with("-:"))
            word.insert(word.begin(), shield);
}

std::string without_shield(std::string word) {
    if (word.starts_with(shield))
        word.erase(word.begin());
    return word;
}

/// Builds the parser; what it reads goes into `to`.
class Parser {
  public:
    explicit Parser(Arguments& to) : to_(to), app_(about, "stltsa") {
        app_.formatter(help_format());
        app_.footer(ending);
        app_.set_version_flag("--version", fmt::format("stltsa {}.{}.{} (libstltsa {})",
                                                       STLTSA_VERSION_MAJOR, STLTSA_VERSION_MINOR,
                                                       STLTSA_VERSION_PATCH, stltsa::version()));
        app_.require_subcommand(1);
        const char* const a_clip = "A clip, or - for standard input.";
        clip_command(Command::info, "info", a_clip);
        CLI::App& fit = clip_command(Command::fit, "fit", a_clip);
        fit.add_option("--coords", to_.coords,
                       "Write the coordinates, rows x d, to a .npy or .csv file.")
            ->type_name("FILE");
        add_product(fit, "Write the model (.stltsa), for map, unmap, denoise and live.");
        add_marks(fit,
                  "A frame of a cycle, which need not be whole, or seconds (2.5s), and the name "
                  "of what happens then, for live.");
        CLI::App& map = model_command(Command::map, "map", a_clip);
        add_product(map, "Write the coordinates to a .npy or .csv file.");
        map.add_flag("--curve", to_.curve,
                     "Add coordinates, distances and nearest rows of all frames to the JSON.");
        CLI::App& unmap =
            model_command(Command::unmap, "unmap", "Coordinates: a CSV or NPY file, or - .");
        add_product(unmap, "Write poses (.bvh, .amc, .glb: glTF) or frames (.npy, .csv).")
            ->required();
        unmap
            .add_flag("--follow", to_.follow,
                      "Continue from the previous point, for coordinates that do not determine the "
                      "pose alone. Sets --hint-window to 2 unless given.")
            ->group(group::method);
        CLI::App& dimension = clip_command(Command::dimension, "dimension", a_clip);
        add_output(dimension);
        CLI::App& decompose = clip_command(Command::decompose, "decompose", a_clip);
        decompose
            .add_option("--plot", to_.plot, "Draw units, curve, loop and cycles into an SVG file.")
            ->type_name("FILE");
        add_output(decompose);
        decompose
            .add_option("--phase", to_.phase,
                        "Write the phase of each frame to a .csv or .npy file: frame, seconds, "
                        "segment, cycle, phase, residual.")
            ->type_name("FILE");
        add_report(decompose, "the units and cycles over time, mean cycles, and tables.");
        decompose.add_flag("--curve", to_.curve,
                           "Add the curve and the loop, sample by sample, to the JSON.");
        add_denoise();
        CLI::App& synthesize = add(Command::synthesize, "synthesize");
        synthesize.add_option("pieces", to_.pieces, "Pieces, in the order of the new motion.")
            ->required();
        add_product(synthesize,
                    "Write the new motion to a .bvh, .amc, .glb (glTF), .csv or .npy file.")
            ->required();
        add_batch();
        add_compare();
        add_events();
        add_output(model_command(Command::live, "live", a_clip));
        set_groups();
        remove_shields();
    }

    void parse(int argc, const char* const* argv) {
        std::vector<std::string> words(argv + 1, argv + argc);
        if (!words.empty() && words[0] == "completions") {
            to_.answer = completions(app_, words.size() == 2 ? words[1] : "");
            return;
        }
        if (!words.empty() && words[0] == "help") { // help fit: fit --help
            std::rotate(words.begin(), words.begin() + 1, words.end());
            words.back() = "--help";
        }
        check_command(words);
        shield_stretches(words);
        std::ranges::reverse(words); // as CLI11 takes them
        try {
            app_.parse(words);
        } catch (const CLI::CallForHelp&) {
            to_.answer = app_.help();
        } catch (const CLI::CallForVersion& version) {
            to_.answer = fmt::format("{}\n", version.what());
        } catch (const CLI::ParseError& error) {
            const CLI::App* chosen =
                app_.get_subcommands().empty() ? nullptr : app_.get_subcommands()[0];
            throw Failure(Exit::usage,
                          fmt::format("{}\nTry 'stltsa {}--help'.",
                                      chosen == nullptr ? error.what() : explained(*chosen, error),
                                      chosen == nullptr ? "" : chosen->get_name() + " "));
        }
    }

  private:
    /// Unknown options come first, because the value of one may have been taken for a clip.
    static std::string explained(const CLI::App& command, const CLI::ParseError& error) {
        const std::vector<std::string> words = command.remaining();
        const auto option =
            std::ranges::find_if(words, [](const std::string& w) { return w.starts_with('-'); });
        if (option != words.end())
            return unknown_option(command, option->substr(0, option->find('=')));
        if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
            return fmt::format("{} takes no further argument '{}'", command.get_name(),
                               without_shield(words.front()));
        const CLI::Option* second = command.get_option_no_throw("second");
        if (second != nullptr && second->count() > 1)
            return "compare takes one or two clips: compare more of them in pairs";
        return error.what();
    }
    static std::string unknown_option(const CLI::App& command, const std::string& name) {
        std::vector<std::string> flags;
        for (const CLI::Option* each : command.get_options())
            std::ranges::copy(dashed_names(*each), std::back_inserter(flags));
        return fmt::format("{} has no option '{}'{}", command.get_name(), name, hint(name, flags));
    }

    /// The parser itself would only say that a command is missing.
    void check_command(const std::vector<std::string>& words) const {
        const std::string first = words.empty() ? "" : words[0];
        std::vector<std::string> names;
        for (const CLI::App* command : app_.get_subcommands({}))
            names.push_back(command->get_name());
        if (std::ranges::find(names, first) != names.end())
            return;
        if (first.starts_with('-') && !is_standard_input(first))
            return check_flag(first);
        check_not_a_path(first);
        const std::string what =
            words.empty() ? "a command is missing" : "there is no command '" + first + "'";
        throw Failure(Exit::usage, fmt::format("{}: give one of {}{}\nTry 'stltsa --help'.", what,
                                               fmt::join(names, ", "), hint(first, names)));
    }

    /// An option before any command.
    void check_flag(const std::string& word) const {
        std::vector<std::string> flags;
        for (const CLI::Option* option : app_.get_options())
            std::ranges::copy(dashed_names(*option), std::back_inserter(flags));
        if (std::ranges::find(flags, word) == flags.end())
            throw Failure(Exit::usage,
                          fmt::format("there is no option '{}' without a command: there are {}{}"
                                      "\nTry 'stltsa --help'.",
                                      word, fmt::join(flags, ", "), hint(word, flags)));
    }

    /// A clip, where a command belongs.
    static void check_not_a_path(const std::string& word) {
        std::error_code none;
        const std::string file = file_of(word);
        const auto missing = [&word](const char* what, const char* line) {
            throw Failure(Exit::usage,
                          fmt::format("'{0}' is {1}, and a command is missing: try "
                                      "'stltsa {2}'",
                                      word, what, fmt::format(fmt::runtime(line), word)));
        };
        if (is_standard_input(word))
            missing("standard input", "decompose {}");
        if (std::filesystem::is_directory(word, none))
            missing("a folder", "batch {} --out results");
        if (std::filesystem::exists(file, none))
            missing("a file", "decompose {}");
        if (looks_like_a_path(word))
            throw Failure(Exit::usage, fmt::format("'{}' is neither a command nor a file\n"
                                                   "Try 'stltsa --help'.",
                                                   word));
    }

    CLI::App& add(Command command, const char* name) {
        CLI::App& app = *app_.add_subcommand(name, about_command(command));
        app.add_flag("--json", to_.json, "Write one JSON object on one line.");
        app.add_flag("-q,--quiet", to_.quiet, "Write only errors to standard error.")
            ->group(group::messages);
        app.add_flag("--no-color", to_.no_color, "No colors, as with NO_COLOR set.")
            ->group(group::messages);
        for (const stltsa::OptionInfo& option : stltsa::option_table())
            if (has_option(command, option))
                add_option_flag(app, option, text_of(command, option), to_.options)
                    ->group(group_of(option));
        app.callback([this, command] { to_.command = command; });
        return app;
    }
    CLI::App& clip_command(Command command, const char* name, const char* input) {
        CLI::App& app = add(command, name);
        app.add_option("clip", to_.input, input)->required();
        return app;
    }
    CLI::App& model_command(Command command, const char* name, const char* input) {
        CLI::App& app = add(command, name);
        app.add_option("model", to_.model, "A model that stltsa fit -o wrote, or -.")->required();
        app.add_option(command == Command::unmap ? "coords" : "clip", to_.input, input)->required();
        return app;
    }
    /// Other flags say what is written.
    void set_groups() {
        app_.get_option("--version")->group(group::messages);
        app_.get_help_ptr()->group(group::messages);
        for (CLI::App* command : app_.get_subcommands({})) {
            command->get_help_ptr()->group(group::messages);
            for (CLI::Option* option : command->get_options())
                if (option->get_group() == "Options")
                    option->group(group::output);
        }
    }
    /// Of the values of all options and positionals, before they are checked.
    void remove_shields() {
        for (CLI::App* command : app_.get_subcommands({}))
            for (CLI::Option* option : command->get_options())
                option->transform(without_shield);
    }
    void add_batch() {
        CLI::App& batch = add(Command::batch, "batch");
        batch.add_option("paths", to_.pieces, "Clips, and folders of clips.")->required();
        batch.add_option("--out", to_.out, "Write the results and the summary into this folder.")
            ->type_name("FOLDER")
            ->required();
        batch
            .add_option("--shard", to_.shard, "Take every n-th clip, from the i-th on: 1/8 to 8/8.")
            ->type_name("I/N")
            ->group(group::method);
        batch.add_option("--jobs", to_.jobs, "Clips at the same time. Default: 1.")
            ->type_name("N")
            ->check(CLI::Range(1, 1024))
            ->group(group::method);
    }
    void add_compare() {
        CLI::App& compare = clip_command(Command::compare, "compare", "The first clip.");
        compare
            .add_option("second", to_.pieces,
                        "The second clip. Without it, left and right of the first are compared.")
            ->expected(0, 1);
        add_output(compare);
        add_report(compare, "the curves of each part, and all differences with their intervals.");
    }
    void add_report(CLI::App& command, const std::string& content) {
        command
            .add_option("--report", to_.report,
                        "Write a report: one HTML page with the moving skeleton or points, " +
                            content)
            ->type_name("FILE");
    }
    void add_events() {
        CLI::App& events = clip_command(Command::events, "events", "The clip with the marks.");
        events.add_option("others", to_.pieces, "Clips in which the events are found, too.");
        add_marks(events, "A frame, which need not be whole, or seconds (2.5s), and the name of "
                          "the event. Several marks with one name make the search more reliable. "
                          "Or a file with labels: .c3d, or a table of events (.csv, .tsv).")
            ->required();
        events
            .add_flag("--both-sides", to_.both_sides,
                      "Find each mark on the other side of the body, too: left_strike as "
                      "right_strike.")
            ->group(group::method);
        add_output(events);
    }
    void add_denoise() {
        CLI::App& denoise = clip_command(Command::denoise, "denoise",
                                         "A model (.stltsa), a clip, or - for either.");
        denoise
            .add_flag("--coordinates", to_.coordinates,
                      "The columns of the CSV or NPY file are coordinates: do not fit.")
            ->group(group::input);
        add_product(denoise, "Write the cleaned coordinates to a .npy or .csv file.");
        denoise
            .add_option("--curve-out", to_.curve_product,
                        "Write the fitted curve to a .npy or .csv file.")
            ->type_name("FILE");
        denoise.add_flag("--curve", to_.curve,
                         "Add coordinates, curve and cleaned coordinates, row by row, to the "
                         "JSON.");
    }
    CLI::Option* add_marks(CLI::App& app, const char* text) {
        return app.add_option("--mark", to_.marks, text)
            ->type_name("FRAME=NAME")
            ->allow_extra_args(false)
            ->group(group::method);
    }
    CLI::Option* add_product(CLI::App& app, const char* text) {
        return app.add_option("-o,--output", to_.product, text)->type_name("FILE");
    }
    void add_output(CLI::App& app) {
        app.add_option("-o,--output", to_.output, "Write the result to a file.")->type_name("FILE");
    }

    Arguments& to_;
    CLI::App app_;
};

/// The word, quoted for a shell if necessary.
std::string shell_word(const std::string& word) {
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                       "0123456789_-+=./:,@%";
    if (!word.empty() && word.find_first_not_of(plain) == word.npos)
        return word;
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + '\'';
}

} // namespace

Arguments parse_arguments(int argc, const char* const* argv) {
    Arguments arguments;
    arguments.line = "stltsa";
    for (int i = 1; i < argc; ++i)
        arguments.line += ' ' + shell_word(argv[i]);
    Parser parser(arguments);
    parser.parse(argc, argv);
    if (ends_in(arguments.output, ".json"))
        arguments.json = true;
    if (arguments.answer.empty())
        check_arguments(arguments);
    return arguments;
}

} // namespace tool
