// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <set>

#include "base/error.hpp"
#include "clip/csv/bids.hpp"
#include "clip/files/names_in.hpp"

namespace stltsa::clip {
namespace {

constexpr std::string_view motion_ending = "_motion.tsv";

/// Whether a folder is one inside a dataset: sub-01, ses-01 or motion.
bool is_inside_dataset(const std::string& name) {
    return name.starts_with("sub-") || name.starts_with("ses-") || name == "motion";
}

/// Adds the motion files of a folder and of those below it.
void collect_motion(const std::string& folder, int depth, std::vector<std::string>& found) {
    for (const std::string& name : names_in(folder, Listed::files))
        if (is_bids_motion(name))
            found.push_back(folder + '/' + name);
    if (depth > 0)
        for (const std::string& name : names_in(folder, Listed::folders))
            if (is_inside_dataset(name))
                collect_motion(folder + '/' + name, depth - 1, found);
}

/// "sub-01", "task-walk", ... of a name.
std::set<std::string> entities_of(std::string_view name) {
    std::set<std::string> entities;
    while (!name.empty()) {
        const std::size_t end = std::min(name.find('_'), name.size());
        if (name.substr(0, end).find('-') != name.npos)
            entities.emplace(name.substr(0, end));
        name.remove_prefix(std::min(end + 1, name.size()));
    }
    return entities;
}

/// The file of the folder that applies and has the most entities; empty: none.
std::string most_specific(const std::string& folder, const std::set<std::string>& own,
                          std::string_view ending) {
    std::string best;
    std::size_t most = 0;
    for (const std::string& name : names_in(folder, Listed::files)) {
        const std::set<std::string> entities = entities_of(name);
        const bool applies = ('_' + name).ends_with(ending) && std::ranges::includes(own, entities);
        if (applies && (best.empty() || entities.size() > most)) {
            best = name;
            most = entities.size();
        }
    }
    return best;
}

} // namespace

bool is_bids_motion(const std::string& path) {
    return std::filesystem::path(path).filename().string().ends_with(motion_ending);
}

std::string motion_file(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored))
        return path;
    constexpr int levels = 3; // sub-01/ses-01/motion
    std::vector<std::string> found;
    collect_motion(path.ends_with('/') ? path.substr(0, path.size() - 1) : path, levels, found);
    if (found.empty())
        return path; // reading it fails, with a text that says what to do
    if (found.size() == 1)
        return found[0];
    constexpr std::size_t most = 8;
    std::string list;
    for (std::size_t i = 0; i < std::min(most, found.size()); ++i)
        list += (i == 0 ? "" : ", ") + found[i];
    fail(Status::argument, "{}: this folder holds {} motion files: give one of {}{}", path,
         found.size(), list, found.size() > most ? ", ..." : "");
}

std::string find_beside(const std::string& motion_path, std::string_view ending) {
    const std::set<std::string> own =
        entities_of(std::filesystem::path(motion_path).filename().string());
    std::filesystem::path folder = std::filesystem::path(motion_path).parent_path();
    for (;;) {
        const std::string shown = folder.empty() ? "." : folder.string();
        if (const std::string name = most_specific(shown, own, ending); !name.empty())
            return (folder / name).string();
        if (!is_inside_dataset(folder.filename().string()) || folder.parent_path() == folder)
            return {};
        folder = folder.parent_path();
    }
}

} // namespace stltsa::clip
