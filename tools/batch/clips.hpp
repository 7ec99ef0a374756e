// SPDX-License-Identifier: BSD-3-Clause
// The clips of a batch, and what identifies their content.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tool::batch {

struct ClipPath {
    std::string path;   ///< to open: as given, or below a folder given; without "." and "//"
    std::string result; ///< file name of the result: the path with "__" for "/", and ".json"
};

struct Found {
    std::vector<ClipPath> clips;
    std::size_t foreign = 0; ///< files in folders that only the Python package reads, left out
};

/// The files among `paths`, and those of readable formats below the folders among them, by path,
/// each path once. The folder of results, `out`, is searched only if it is among `paths`, and then
/// without the summaries. Tables that describe recordings of BIDS are no clips. Throws Failure with
/// Exit::usage if two have one result, or if there is none.
Found find_clips(const std::vector<std::string>& paths, const std::string& out);

/// "3 files left out, ...": how they are read.
std::string left_out(std::size_t foreign);

/// Part i of n, "i/n" counted from 1: every n-th clip, so that long folders are spread.
struct Shard {
    std::size_t index = 1;
    std::size_t count = 1;
};

/// Throws Failure with Exit::usage.
Shard parse_shard(const std::string& text);
std::vector<ClipPath> clips_of(const Shard& shard, const std::vector<ClipPath>& clips);

/// Size and CRC-32 of a clip's file, with those of the skeletons that it may need, or of the files
/// that describe a recording of Motion-BIDS.
struct Content {
    std::uint64_t bytes = 0;
    std::uint32_t crc32 = 0;
};

/// Throws std::system_error.
Content content_of(const std::string& path, const std::string& skeleton);

} // namespace tool::batch
