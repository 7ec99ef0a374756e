// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <stltsa.hpp>

#include "arguments.hpp"
#include "json.hpp"
#include "output.hpp"
#include "progress_bar.hpp"

namespace tool {

/// What every command does: options set, the input read, the result written. Throws Failure.
class Session {
  public:
    /// Sets the options, and refuses places where no file can be made.
    explicit Session(const Arguments& arguments);

    /// Opens arguments.input; lengths given in seconds are counted in its frames.
    const stltsa::Clip& open_input();
    const stltsa::Clip& clip() const { return *clip_; }
    stltsa::Clip open_clip(const std::string& path) const;
    stltsa::Model open_model(const std::string& path) const;

    /// Whether arguments.input is a model: by its name or, of standard input, by how it begins.
    bool input_is_model() const;

    /// As option fps: the rate that a file was found to have.
    void set_fps(double fps);
    const stltsa::Options& options() const { return options_; }
    /// What an option that nobody typed is here.
    void set_default(std::int32_t key, std::int64_t value);
    const Arguments& arguments() const { return arguments_; }

    /// What people call the clip: the file's name without its folder.
    std::string title() const;
    /// Whether the table gets colors.
    bool colors() const;

    void add_file(const std::string& path, std::string content);
    /// As NPY or CSV, as the suffix says; the columns of a CSV are headed y1, y2 and so on.
    void add_table(const std::string& path, const stltsa::Matrix& table, const char* column = "y");
    /// Its format is told by the suffix. The clip must live until finish(), as a model must.
    void add_clip(const std::string& path, const stltsa::Clip& clip);
    void add_model(const std::string& path, const stltsa::Model& model);
    /// Writes the object as JSON or, without --json, `table`; then puts the files in their places.
    void finish(const Json& object, const std::string& table);

  private:
    void warn(const Json& object) const;
    /// Read once.
    const std::string& standard_input() const;

    const Arguments& arguments_;
    ProgressBar bar_;
    stltsa::Options options_;
    std::optional<stltsa::Clip> clip_;
    mutable std::optional<std::string> standard_input_;
    OutputFiles files_;
};

} // namespace tool
