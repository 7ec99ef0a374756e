// SPDX-License-Identifier: BSD-3-Clause
#include "clip/files/names_in.hpp"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <new>

#include <dirent.h>
#include <sys/stat.h>

namespace stltsa::clip {
namespace {

/// Opening anything but a regular file, such as a pipe, may wait for its writer.
bool is_wanted(const std::string& path, Listed wanted) {
    if (wanted == Listed::all)
        return true;
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0)
        return false;
    return wanted == Listed::files ? S_ISREG(status.st_mode) : S_ISDIR(status.st_mode);
}

} // namespace

/// std::filesystem's iterator would terminate the process if memory runs out.
std::vector<std::string> names_in(const std::string& folder, Listed wanted) {
    const std::unique_ptr<DIR, int (*)(DIR*)> listed(::opendir(folder.c_str()), &::closedir);
    if (!listed && errno == ENOMEM)
        throw std::bad_alloc();
    std::vector<std::string> names;
    while (const dirent* entry = listed ? ::readdir(listed.get()) : nullptr) {
        const std::string name = entry->d_name;
        if (!name.starts_with('.') && is_wanted(folder + '/' + name, wanted))
            names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace stltsa::clip
