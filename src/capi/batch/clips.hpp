// SPDX-License-Identifier: BSD-3-Clause
// The clips of a batch, and what identifies their content.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa::capi::batch {

/// The files among `paths`, and the clips in the folders among them and below, by path, each path
/// once: as given, or below a folder given, without "." and "//". Throws Status::argument if two
/// have one result, or if there is none.
std::vector<std::string> find_clips(std::span<const char* const> paths);

/// Part "i/n" of the clips, counted from 1: every n-th, so that long folders are spread.
std::vector<std::string> part_of(const std::vector<std::string>& clips, std::string_view shard);

/// File name of the result: the path with "__" for "/", and ".json".
std::string result_name(std::string path);

/// Size and CRC-32 of a clip's file, with those of `skeleton` or, if that is empty, of the files
/// that the library would look at: skeletons beside it, or what describes a recording of BIDS.
struct Content {
    std::uint64_t bytes = 0;
    std::uint32_t crc32 = 0;
};
Content content_of(const std::string& path, const std::string& skeleton);

} // namespace stltsa::capi::batch
