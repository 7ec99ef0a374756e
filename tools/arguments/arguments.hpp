// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tool {

enum class Command {
    info,
    fit,
    map,
    unmap,
    dimension,
    decompose,
    denoise,
    synthesize,
    batch,
    compare,
    events,
    live
};

/// The command line, read.
struct Arguments {
    Command command = Command::info;
    std::string input;               ///< "-": standard input
    std::string model;               ///< map, unmap: the model file
    std::vector<std::string> pieces; ///< synthesize; batch: files and folders; events: more clips;
                                     ///< compare: the second clip
    std::map<std::int32_t, std::string> options; ///< by STLTSA_* key, as typed
    std::string output;        ///< of the text that says what was found; empty: standard output
    std::string product;       ///< what fit, map, unmap, denoise, synthesize make; empty: nothing
    std::string curve_product; ///< denoise: the fitted curve
    std::string plot;
    std::string coords;
    bool both_sides = false;        ///< events: those of the other side as well
    std::vector<std::string> marks; ///< events: "FRAME=NAME"
    std::string phase;              ///< decompose: the phase of each frame
    std::string report;             ///< decompose: the HTML page
    std::string line;               ///< the command line, quoted for a shell
    std::string out;                ///< batch: the folder of results
    std::string shard;              ///< batch: "i/n"; empty: all
    int jobs = 1;                   ///< batch: clips at the same time
    bool json = false;
    bool curve = false;       ///< in the JSON
    bool coordinates = false; ///< denoise: the input's columns are coordinates
    bool follow = false;      ///< unmap: each row is near the one before
    bool quiet = false;
    bool no_color = false;

    /// The files that the options name, apart from the text.
    std::vector<std::string> products() const {
        return {product, curve_product, coords, phase, plot, report};
    }

    std::string answer; ///< not empty: a --help or --version to print instead
};

/// Whether one of the products goes to standard output, so that the text does not.
bool stdout_is_taken(const Arguments& arguments);

/// Throws Failure with Exit::usage for a wrong command line.
Arguments parse_arguments(int argc, const char* const* argv);

} // namespace tool
