// SPDX-License-Identifier: BSD-3-Clause
// Results reach their place whole or not at all.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/replace_file.hpp"

namespace tool {

/// Writes all of it to standard output. Throws Failure when that fails (full disk, closed pipe).
void write_stdout(std::string_view text);

/// The files of one run: each is written beside its place, and all are moved there by commit().
/// Without a commit() nothing stays. What is no regular file (/dev/full, a pipe) is written to
/// directly, by commit().
class OutputFiles {
  public:
    void add(const std::string& path, std::string content);
    /// The same of a file that `write` makes under the name that it is given, whose suffix is that
    /// of `path`.
    using Write = std::function<void(const std::string& name)>;
    void add_written(const std::string& path, const Write& write);
    void commit();

  private:
    struct Staged {
        std::string name; ///< as it was given
        std::optional<stltsa::clip::TemporaryFile> temporary;
        std::function<void()> write; ///< of those without a temporary
    };
    std::vector<Staged> staged_;
};

/// Throws Failure early where a file could not be made there later, or would replace one of
/// `taken`: an input, or another output.
void check_output_place(const std::string& path, const std::vector<std::string>& taken);

} // namespace tool
