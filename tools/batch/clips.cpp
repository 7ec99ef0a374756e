// SPDX-License-Identifier: BSD-3-Clause
#include "batch/clips.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <zlib.h>

#include "exit_status.hpp"
#include "terminal/text.hpp"

namespace tool::batch {
namespace {

namespace fs = std::filesystem;

constexpr const char* suffixes[] = {".bvh", ".amc", ".csv", ".tsv", ".npy"};

bool is_readable(const fs::path& path) {
    return std::ranges::any_of(suffixes,
                               [&](const char* suffix) { return ends_in(path.string(), suffix); });
}

void add_folder(const fs::path& folder, std::vector<ClipPath>& clips) {
    constexpr auto options = fs::directory_options::follow_directory_symlink |
                             fs::directory_options::skip_permission_denied;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, options))
        if (entry.is_regular_file() && is_readable(entry.path()))
            clips.push_back(
                {entry.path().string(), entry.path().lexically_relative(folder).generic_string()});
}

void add_content(const std::string& path, Content& content) {
    std::ifstream file(path, std::ios::binary);
    std::vector<char> block(std::size_t{1} << 16);
    uLong sum = content.crc32;
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())) ||
           file.gcount() > 0) {
        const auto count = static_cast<uInt>(file.gcount());
        sum = ::crc32(sum, reinterpret_cast<const Bytef*>(block.data()), count);
        content.bytes += count;
    }
    if (!file.eof())
        throw std::system_error(errno, std::generic_category(), path);
    content.crc32 = static_cast<std::uint32_t>(sum);
}

/// Those of the folder: which of them the clip takes is found when it is opened.
std::vector<std::string> skeletons_beside(const fs::path& clip) {
    std::vector<std::string> found;
    const fs::path folder = clip.has_parent_path() ? clip.parent_path() : ".";
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (ends_in(entry.path().string(), ".asf"))
            found.push_back(entry.path().string());
    std::ranges::sort(found);
    return found;
}

} // namespace

std::vector<ClipPath> find_clips(const std::vector<std::string>& paths) {
    std::vector<ClipPath> clips;
    for (const std::string& path : paths)
        if (fs::is_directory(path))
            add_folder(path, clips);
        else // also one that does not exist, which becomes a row with its error
            clips.push_back({path, fs::path(path).filename().generic_string()});
    std::ranges::sort(clips, {}, &ClipPath::name);
    const auto twice = std::ranges::adjacent_find(clips, {}, &ClipPath::name);
    if (twice != clips.end())
        throw Failure(Exit::usage,
                      fmt::format("{} and {} would have the same result, {}.json: give their "
                                  "common folder",
                                  twice->path, std::next(twice)->path, twice->name));
    if (clips.empty())
        throw Failure(Exit::usage, "there are no .bvh, .amc, .csv, .tsv or .npy files");
    return clips;
}

Shard parse_shard(const std::string& text) {
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, shard.index);
    const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
    const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
    if (!slash || second.ec != std::errc() || second.ptr != end || shard.index < 1 ||
        shard.index > shard.count)
        throw Failure(Exit::usage, fmt::format("--shard is given '{}': it takes a part of all, "
                                               "such as 2/8",
                                               text));
    return shard;
}

std::vector<ClipPath> clips_of(const Shard& shard, const std::vector<ClipPath>& clips) {
    std::vector<ClipPath> part;
    for (std::size_t i = shard.index - 1; i < clips.size(); i += shard.count)
        part.push_back(clips[i]);
    return part;
}

Content content_of(const std::string& path, const std::string& skeleton) {
    Content content;
    add_content(path, content);
    if (!skeleton.empty())
        add_content(skeleton, content);
    else if (ends_in(path, ".amc"))
        for (const std::string& found : skeletons_beside(path))
            add_content(found, content);
    return content;
}

} // namespace tool::batch
