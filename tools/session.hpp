// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "arguments.hpp"
#include "library.hpp"
#include "output.hpp"
#include "progress_bar.hpp"

namespace tool {

/// What every command does: options set, the clip read, the result written.
class Session {
  public:
    /// Opens the clip. Throws Failure.
    explicit Session(const Arguments& arguments);

    const stltsa_clip* clip() const { return clip_.get(); }
    const stltsa_options* options() const { return options_.get(); }
    const Arguments& arguments() const { return arguments_; }

    /// What people call the clip: the file's name without its folder.
    std::string title() const;
    /// Whether the table gets colors.
    bool colors() const;

    void add_file(const std::string& path, std::string content);
    /// Writes the object as JSON or, without --json, `table`; then puts the files in their places.
    void finish(const Json& object, const std::string& table);

  private:
    void read_clip();
    void warn(const Json& object) const;

    const Arguments& arguments_;
    ProgressBar bar_;
    Options options_;
    Clip clip_;
    OutputFiles files_;
};

} // namespace tool
