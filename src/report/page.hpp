// SPDX-License-Identifier: BSD-3-Clause
// The report of a clip: one HTML page that needs nothing else.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "clip/clip.hpp"
#include "clip/features/prepare.hpp"
#include "results/decomposed.hpp"

namespace stltsa::report {

/// What a report is made of.
struct Reported {
    const clip::Clip& clip;
    const results::Decomposed& decomposed; ///< of this clip
    clip::PrepareOptions prepare;          ///< with which it was decomposed
    std::string json;                      ///< of the decomposition
    std::string command;                   ///< which repeats it; empty: unknown
    std::string name;                      ///< how commands name the clip; empty: unknown
    std::vector<clip::Frames> pieces;      ///< of the file, of which the clip consists; empty: all
    /// Of commands, by name: flags for the options with which the clip was read and decomposed.
    std::vector<std::pair<const char*, std::string>> flags;
};

/// The page. Throws Status::argument if the decomposition is not of the clip.
std::string page(const Reported& reported, const Progress& progress);

} // namespace stltsa::report
