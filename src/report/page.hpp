// SPDX-License-Identifier: BSD-3-Clause
// The report of a clip: one HTML page that needs nothing else.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features/prepare.hpp"
#include "results/decomposed.hpp"

namespace stltsa::report {

/// What a report is made of.
struct Reported {
    const clip::Clip& clip;
    const results::Decomposed& decomposed; ///< of this clip
    clip::PrepareOptions prepare;          ///< those of the decomposition
    std::string json;                      ///< the decomposition as JSON
    std::string command;                   ///< makes the report again; empty: unknown
    std::string name;                      ///< of the clip in commands; empty: unknown
    std::vector<clip::Frames> pieces;      ///< of the file, of which the clip consists; empty: all
    /// By command: flags for the options with which the clip was read and decomposed.
    std::vector<std::pair<const char*, std::string>> flags;
};

/// The page. Throws Status::argument if the decomposition is not of the clip.
std::string page(const Reported& reported);

} // namespace stltsa::report
