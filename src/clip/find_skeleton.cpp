// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>

#include "clip/formats.hpp"
#include "clip/text_cursor.hpp"

namespace stltsa::clip {
namespace {

namespace fs = std::filesystem;

/// All ASF files of a folder, in a fixed order.
std::vector<fs::path> asf_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error; // a folder that cannot be listed has none
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (equals_ignoring_case(entry->path().extension().string(), ".asf"))
            files.push_back(entry->path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

std::string find_skeleton(const std::string& amc_path) {
    const fs::path amc(amc_path);
    const fs::path folder = amc.has_parent_path() ? amc.parent_path() : fs::path(".");
    const std::vector<fs::path> files = asf_files(folder);
    const std::string stem = amc.stem().string();
    for (const std::string& wanted : {stem, stem.substr(0, stem.find('_'))})
        for (const fs::path& file : files)
            if (equals_ignoring_case(file.stem().string(), wanted))
                return (amc.parent_path() / file.filename()).string();
    if (files.size() == 1)
        return (amc.parent_path() / files[0].filename()).string();
    fail(Status::io,
         "{}: an AMC file needs its skeleton, and {}.asf is not beside it ({} other ASF files "
         "are): set option skeleton to the path of the ASF file",
         amc_path, stem.substr(0, stem.find('_')), files.size());
}

} // namespace stltsa::clip
