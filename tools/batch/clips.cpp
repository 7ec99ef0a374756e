// SPDX-License-Identifier: BSD-3-Clause
#include "batch/clips.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <zlib.h>

#include "arguments/pieces.hpp"
#include "exit_status.hpp"
#include "terminal/text.hpp"

namespace tool::batch {
namespace {

namespace fs = std::filesystem;

constexpr const char* readable[] = {".bvh", ".amc", ".csv", ".tsv", ".npy",
                                    ".c3d", ".trc", ".mot", ".sto"};
/// Formats that only the Python package reads.
constexpr const char* foreign[] = {".npz", ".nc"};
/// Tables of BIDS datasets that describe recordings.
constexpr const char* descriptions[] = {"_channels.tsv", "_events.tsv", "_scans.tsv",
                                        "_sessions.tsv", "_participants.tsv"};

bool ends_in_one(const std::string& path, std::span<const char* const> suffixes) {
    return std::ranges::any_of(suffixes, [&](const char* suffix) { return ends_in(path, suffix); });
}

/// Without "." and double slashes; ".." stays, since links may come before it.
std::string plain(const fs::path& path) {
    fs::path result;
    for (const fs::path& part : path)
        if (part != "." && !part.empty())
            result /= part;
    return result.empty() ? "." : result.string();
}

/// Folders above are left out, so that no name begins with dots, which would hide the file.
std::string result_name(std::string path) {
    while (path.starts_with("../"))
        path.erase(0, 3);
    for (std::size_t at = 0; (at = path.find('/', at)) != path.npos;)
        path.replace(at, 1, "__");
    return path + ".json";
}

/// The folder without links and dots, also if it does not exist yet.
fs::path real(const fs::path& folder) {
    std::error_code none;
    return fs::weakly_canonical(fs::absolute(folder, none), none);
}

/// "summary.csv", or that of a shard, "summary-2-8.csv".
bool is_summary(const std::string& name) {
    constexpr std::string_view begin = "summary", end = ".csv";
    return name.starts_with(begin) && name.ends_with(end) &&
           name.find_first_not_of("-0123456789", begin.size()) == name.size() - end.size();
}

/// The clips of a folder and of those in it. Links are followed, into each folder once: they may
/// lead back. What cannot be listed is left out. The summaries of earlier runs and of other shards
/// are no clips: the folder of results is left out, or if it is the given one, only they are.
class Search {
  public:
    Search(Found& found, const std::string& out) : found_(found), out_(real(out)) {}

    void given(const fs::path& folder) {
        if (real(folder) != out_)
            seen_.insert(out_);
        this->folder(folder);
    }

  private:
    void folder(const fs::path& folder) {
        std::error_code none;
        const fs::path place = real(folder);
        if (!seen_.insert(place).second)
            return;
        std::vector<fs::path> entries;
        for (fs::directory_iterator entry(folder, none), end; entry != end; entry.increment(none))
            entries.push_back(entry->path());
        std::ranges::sort(entries);
        for (const fs::path& entry : entries)
            if (fs::is_directory(entry, none))
                this->folder(entry);
            else if (fs::is_regular_file(entry, none) &&
                     !(place == out_ && is_summary(entry.filename().string())))
                file(plain(entry));
    }

    void file(const std::string& path) {
        if (ends_in_one('_' + fs::path(path).filename().string(), descriptions))
            return;
        if (ends_in_one(path, readable))
            found_.clips.push_back({path, result_name(path)});
        else if (ends_in_one(path, foreign))
            ++found_.foreign;
    }

    Found& found_;
    fs::path out_;
    std::set<fs::path> seen_;
};

/// Reading a pipe would wait for its writer.
void add_content(const std::string& path, Content& content) {
    std::error_code none;
    if (fs::exists(path, none) && !fs::is_regular_file(path, none))
        throw Failure(
            Exit::failed,
            fmt::format("{}: not a file; batch reads only files, because it reads them twice",
                        path));
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

/// The files of a folder that end so, by name.
std::vector<std::string> files_in(const fs::path& folder, std::span<const char* const> endings) {
    std::vector<std::string> found;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with('.') && ends_in_one(name, endings) && entry.is_regular_file(none))
            found.push_back(entry.path().string());
    }
    std::ranges::sort(found);
    return found;
}

/// Those that the library would look at: which of them the clip takes is found when it is opened.
std::vector<std::string> files_beside(const fs::path& clip) {
    constexpr const char* skeletons[] = {".asf"};
    constexpr const char* of_motion[] = {"channels.tsv", "motion.json"};
    fs::path folder = clip.parent_path();
    if (ends_in(clip.string(), ".amc"))
        return files_in(folder, skeletons);
    std::vector<std::string> found;
    for (bool inside = ends_in(clip.string(), "_motion.tsv"); inside;) {
        const std::vector<std::string> here = files_in(folder, of_motion);
        found.insert(found.end(), here.begin(), here.end());
        const std::string name = folder.filename().string();
        // Those above the folders of a subject and a session apply, too.
        inside = name.starts_with("sub-") || name.starts_with("ses-") || name == "motion";
        folder = folder.parent_path();
    }
    return found;
}

} // namespace

Found find_clips(const std::vector<std::string>& paths, const std::string& out) {
    Found found;
    std::vector<ClipPath>& clips = found.clips;
    for (const std::string& given : paths) {
        std::error_code none;
        if (is_standard_input(given))
            throw Failure(Exit::usage, "batch takes files and folders: for standard input, use "
                                       "stltsa decompose - --json");
        if (fs::is_directory(given, none))
            Search(found, out).given(plain(given));
        else // also one that does not exist, which becomes a row with its error
            clips.push_back({plain(given), result_name(plain(given))});
    }
    std::ranges::sort(clips, {}, &ClipPath::path);
    // Clang 14 does not compile std::ranges::unique with GCC's library.
    const auto same = [](const ClipPath& a, const ClipPath& b) { return a.path == b.path; };
    clips.erase(std::unique(clips.begin(), clips.end(), same), clips.end());
    std::map<std::string, std::string> taken;
    for (const ClipPath& clip : clips)
        if (const auto [other, fresh] = taken.emplace(clip.result, clip.path); !fresh)
            throw Failure(Exit::usage, fmt::format("{} and {} would have the same result, {}: "
                                                   "decompose them into two folders",
                                                   other->second, clip.path, clip.result));
    if (clips.empty())
        throw Failure(Exit::usage,
                      fmt::format("there are no {} files{}{}", fmt::join(readable, ", "),
                                  found.foreign > 0 ? "; " : "",
                                  found.foreign > 0 ? left_out(found.foreign) : ""));
    return found;
}

std::string left_out(std::size_t foreign) {
    return fmt::format("{} left out, of formats that only the Python package reads, such as AMASS",
                       counted(static_cast<std::int64_t>(foreign), "file"));
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
    else
        for (const std::string& found : files_beside(path))
            add_content(found, content);
    return content;
}

} // namespace tool::batch
