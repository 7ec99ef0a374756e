// SPDX-License-Identifier: BSD-3-Clause
#include "clip/acclaim/find_skeleton.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <dirent.h>
#include <sys/stat.h>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

namespace fs = std::filesystem;

bool is_regular_file(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

/// The sorted names of the ASF files of a folder. Regular files only: opening a pipe would wait for
/// its writer. Not hidden ones: another program may be writing one. std::filesystem's iterator
/// would terminate the process if memory runs out.
std::vector<std::string> asf_files(const std::string& folder) {
    const std::unique_ptr<DIR, int (*)(DIR*)> listed(::opendir(folder.c_str()), &::closedir);
    if (!listed && errno == ENOMEM)
        throw std::bad_alloc();
    std::vector<std::string> names; // empty if the folder cannot be listed
    while (const dirent* entry = listed ? ::readdir(listed.get()) : nullptr) {
        const std::string name = entry->d_name;
        if (!name.starts_with('.') &&
            equals_ignoring_case(fs::path(name).extension().string(), ".asf") &&
            is_regular_file(folder + '/' + name))
            names.push_back(name);
    }
    std::sort(names.begin(), names.end());
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
