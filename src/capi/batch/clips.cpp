// SPDX-License-Identifier: BSD-3-Clause
#include "capi/batch/clips.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <set>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/error.hpp"
#include "capi/batch/result.hpp"
#include "clip/clip.hpp"
#include "clip/files/descriptor.hpp"
#include "clip/files/names_in.hpp"
#include "clip/files/read_file.hpp"
#include "clip/files/replace_file.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::capi::batch {
namespace {

namespace fs = std::filesystem;

bool ends_in_one(std::string_view name, std::initializer_list<std::string_view> endings) {
    const std::string small = clip::to_lower(name);
    return std::ranges::any_of(endings, [&](auto ending) { return small.ends_with(ending); });
}

/// Without "." and double slashes; ".." stays, since links may come before it.
std::string plain(const fs::path& path) {
    fs::path result;
    for (const fs::path& part : path)
        if (part != "." && !part.empty())
            result /= part;
    return result.empty() ? "." : result.string();
}

/// Whether an earlier run, or that of another shard, wrote this table.
bool is_summary(const std::string& path) {
    std::error_code none;
    if (!fs::is_regular_file(path, none) || ::access(path.c_str(), R_OK) != 0)
        return false;
    std::array<char, summary_begin.size()> begin{};
    clip::read_some(clip::Descriptor(path, O_RDONLY).number(), begin);
    return std::string_view(begin.data(), begin.size()) == summary_begin;
}

/// A table of a BIDS dataset that describes recordings.
bool is_description(const std::string& name) {
    return ends_in_one('_' + name, {"_channels.tsv", "_events.tsv", "_scans.tsv", "_sessions.tsv",
                                    "_participants.tsv"});
}

/// The clips of a folder and of those in it. Links are followed, into each folder once: they may
/// lead back. Pipes, links that lead nowhere and folders that cannot be listed are among the clips:
/// their rows say why they cannot be read.
class Search {
  public:
    explicit Search(std::vector<std::string>& clips) : clips_(clips) {}

    void folder(const std::string& folder) {
        struct stat place {};
        if (::stat(folder.c_str(), &place) != 0 ||
            !seen_.emplace(place.st_dev, place.st_ino).second)
            return;
        if (::access(folder.c_str(), R_OK) != 0)
            clips_.push_back(folder);
        for (const std::string& name : clip::names_in(folder, clip::Listed::all)) {
            const std::string path = plain(folder + '/' + name);
            std::error_code none;
            if (fs::is_directory(path, none))
                this->folder(path);
            else if (clip::is_clip_name(name) && !is_description(name) && !is_summary(path))
                clips_.push_back(path);
        }
    }

  private:
    std::vector<std::string>& clips_;
    std::set<std::pair<dev_t, ino_t>> seen_;
};

/// Reading a pipe would wait for its writer.
void add_file(const std::string& path, Content& content) {
    std::error_code none;
    if (!clip::regular_or_new(path) && !fs::is_directory(path, none))
        fail(Status::io, "{}: not a file; batch reads only files, because it reads them twice",
             path);
    const std::string bytes = clip::read_file(path);
    content.bytes += bytes.size();
    content.crc32 = static_cast<std::uint32_t>(
        ::crc32_z(content.crc32, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// The files of a folder that end so, by name.
void add_files(const fs::path& folder, std::initializer_list<std::string_view> endings,
               Content& content) {
    const std::string listed = folder.empty() ? "." : folder.string();
    for (const std::string& name : clip::names_in(listed, clip::Listed::files))
        if (ends_in_one(name, endings))
            add_file((folder / name).string(), content);
}

} // namespace

/// Folders above are left out, so that no name begins with dots, which would hide the file.
std::string result_name(std::string path) {
    while (path.starts_with("../"))
        path.erase(0, 3);
    for (std::size_t at = 0; (at = path.find('/', at)) != path.npos;)
        path.replace(at, 1, "__");
    return path + ".json";
}

std::vector<std::string> find_clips(std::span<const char* const> paths) {
    std::vector<std::string> clips;
    for (const std::string given : paths) {
        std::error_code none;
        if (given == "-" || given.starts_with("-:"))
            fail(Status::argument, "batch takes files and folders: for standard input, use "
                                   "stltsa decompose - --json");
        if (fs::is_directory(given, none))
            Search(clips).folder(plain(given));
        else // also one that does not exist, which becomes a row with its error
            clips.push_back(plain(given));
    }
    std::ranges::sort(clips);
    // Clang 14 does not compile std::ranges::unique with GCC's library.
    clips.erase(std::unique(clips.begin(), clips.end()), clips.end());
    std::map<std::string, std::string> taken;
    for (const std::string& path : clips)
        if (const auto [other, fresh] = taken.emplace(result_name(path), path); !fresh)
            fail(Status::argument,
                 "{} and {} would have the same result, {}: decompose them into two folders",
                 other->second, path, other->first);
    if (clips.empty())
        fail(Status::argument, "there are no {} files", clip::suffixes_read());
    return clips;
}

std::vector<std::string> part_of(const std::vector<std::string>& clips, std::string_view shard) {
    std::size_t index = 0, count = 0;
    const char* const end = shard.data() + shard.size();
    const auto first = std::from_chars(shard.data(), end, index);
    const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
    const auto second = slash ? std::from_chars(first.ptr + 1, end, count) : first;
    if (!slash || second.ec != std::errc() || second.ptr != end || index < 1 || index > count)
        fail(Status::argument, "the shard is {}: give a part of all, such as 2/8",
             clip::in_quotes(shard));
    std::vector<std::string> part;
    for (std::size_t i = index - 1; i < clips.size(); i += count)
        part.push_back(clips[i]);
    return part;
}

Content content_of(const std::string& path, const std::string& skeleton) {
    Content content;
    add_file(path, content);
    fs::path folder = fs::path(path).parent_path();
    if (!skeleton.empty())
        add_file(skeleton, content);
    else if (ends_in_one(path, {".amc"}))
        add_files(folder, {".asf"}, content);
    else
        for (bool inside = ends_in_one(path, {"_motion.tsv"}); inside;) {
            add_files(folder, {"channels.tsv", "motion.json"}, content);
            // Those above the folders of a subject and a session apply, too.
            const std::string name = folder.filename().string();
            inside = name.starts_with("sub-") || name.starts_with("ses-") || name == "motion";
            folder = folder.parent_path();
        }
    return content;
}

} // namespace stltsa::capi::batch
