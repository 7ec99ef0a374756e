// SPDX-License-Identifier: BSD-3-Clause
// Files are written completely or not at all.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/files/replace_file.hpp"

namespace tool {

/// The path that means standard output.
inline constexpr std::string_view standard_output = "-";

/// Writes the text to standard output. Throws Failure if that fails (full disk, closed pipe).
void write_stdout(std::string_view text);

/// The files of one run: each is written next to its destination, and commit() moves them all
/// there. Without commit() no file remains. commit() first writes what goes to standard output and
/// to destinations that are not regular files (/dev/full, a pipe): if that fails, no file remains.
class OutputFiles {
  public:
    void add(const std::string& path, std::string content);
    /// The same for a file that `write` creates under a given name, which has this suffix.
    using Write = std::function<void(const std::string& name)>;
    void add_written(const std::string& path, const std::string& suffix, const Write& write);
    void commit();

  private:
    struct Staged {
        std::string name; ///< as given
        std::optional<stltsa::clip::TemporaryFile> temporary;
        std::function<void()> write; ///< if there is no temporary file
    };
    void add_to_stdout(std::string content);

    std::vector<Staged> staged_;
};

/// Throws Failure early if a file could not be created there later, or would replace one of
/// `taken`: an input or another output.
void check_output_place(const std::string& path, const std::vector<std::string>& taken);

} // namespace tool
