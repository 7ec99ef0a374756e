// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/checks.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stltsa.hpp>

#include "arguments/pieces.hpp"
#include "clip/files/replace_file.hpp"
#include "exit_status.hpp"
#include "terminal/output.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

using Suffixes = std::vector<std::string_view>;

/// Standard output needs no suffix, nor do pipes and devices; /dev/stdout may be a file, too.
bool needs_suffix(const std::string& path) {
    return !path.empty() && path != standard_output && !path.starts_with("/dev/") &&
           stltsa::clip::regular_or_new(path);
}

void check_suffix(const char* flag, const std::string& path, const Suffixes& suffixes) {
    const auto fits = [&](std::string_view suffix) { return ends_in(path, suffix); };
    if (!suffixes.empty() && needs_suffix(path) && std::ranges::none_of(suffixes, fits))
        throw Failure(Exit::usage, fmt::format("{} {}: the name must end in {}", flag, path,
                                               fmt::join(suffixes, ", ")));
}

/// Of the text, JSON or a table.
Suffixes text_suffixes(Command command) {
    return command == Command::dimension ? Suffixes{".json", ".txt"}
                                         : Suffixes{".csv", ".json", ".txt"};
}

/// Of what the command makes.
Suffixes product_suffixes(Command command) {
    switch (command) {
    case Command::fit:
        return {".stltsa"};
    case Command::map:
    case Command::denoise:
        return {".npy", ".csv"};
    case Command::unmap:
    case Command::synthesize:
        return {".bvh", ".amc", ".glb", ".npy", ".csv"};
    default:
        return {};
    }
}

void check_suffixes(const Arguments& arguments) {
    const Suffixes table{".npy", ".csv"};
    check_suffix("--coords", arguments.coords, table);
    check_suffix("--phase", arguments.phase, table);
    check_suffix("--curve-out", arguments.curve_product, table);
    check_suffix("--plot", arguments.plot, {".svg"});
    check_suffix("--report", arguments.report, {".html"});
    check_suffix("-o", arguments.product, product_suffixes(arguments.command));
    check_suffix("-o", arguments.output, text_suffixes(arguments.command));
    if (ends_in(arguments.output, ".csv") && arguments.json)
        throw Failure(
            Exit::usage,
            fmt::format("--output {}: JSON goes to a file that ends in .json", arguments.output));
}

void check_streams(const Arguments& arguments) {
    const auto products = arguments.products();
    const auto streams = std::ranges::count(products, standard_output);
    const bool text =
        arguments.output == standard_output ||
        (arguments.json && arguments.output.empty() && arguments.command != Command::batch);
    if (streams > 1 || (streams == 1 && text))
        throw Failure(Exit::usage, "standard output (-) takes one result: name files for the "
                                   "others");
    if (is_standard_input(arguments.model) && is_standard_input(arguments.input))
        throw Failure(Exit::usage, "standard input (-) is one file: the model or the other");
}

} // namespace

void check_arguments(const Arguments& arguments) {
    check_suffixes(arguments);
    check_streams(arguments);
    if (arguments.command == Command::unmap && !arguments.follow &&
        arguments.options.contains(STLTSA_OPT_HINT_WINDOW))
        throw Failure(Exit::usage, "--hint-window goes with --follow");
    if (arguments.curve && !arguments.json)
        throw Failure(Exit::usage, "--curve goes with --json");
    if (arguments.command == Command::fit && !arguments.marks.empty() && arguments.product.empty())
        throw Failure(Exit::usage, "--mark goes with -o: the model keeps the mark");
}

bool stdout_is_taken(const Arguments& arguments) {
    const auto products = arguments.products();
    return std::ranges::find(products, standard_output) != products.end();
}

} // namespace tool
