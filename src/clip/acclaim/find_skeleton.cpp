// SPDX-License-Identifier: BSD-3-Clause
#include "clip/acclaim/find_skeleton.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "clip/files/names_in.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> asf_files(const std::string& folder) {
    std::vector<std::string> names = names_in(folder, Listed::files);
    std::erase_if(names, [](const std::string& name) {
        return !equals_ignoring_case(fs::path(name).extension().string(), ".asf");
    });
    return names;
}

} // namespace

std::string find_skeleton(const std::string& amc_path) {
    const fs::path amc(amc_path);
    const fs::path folder = amc.has_parent_path() ? amc.parent_path() : fs::path(".");
    const std::vector<std::string> files = asf_files(folder.string());
    const std::string stem = amc.stem().string();
    if (const std::string own = stem + ".asf"; std::ranges::binary_search(files, own))
        return (amc.parent_path() / own).string(); // as written beside it, whatever else is here
    for (const std::string& wanted : {stem, stem.substr(0, stem.find('_'))})
        for (const std::string& file : files)
            if (equals_ignoring_case(fs::path(file).stem().string(), wanted))
                return (amc.parent_path() / file).string();
    if (files.size() == 1)
        return (amc.parent_path() / files[0]).string();
    fail(Status::io,
         "{}: an AMC file needs its skeleton, but its folder has no {}.asf ({} other ASF files): "
         "set option skeleton to the path of the ASF file",
         amc_path, stem.substr(0, stem.find('_')), files.size());
}

} // namespace stltsa::clip
