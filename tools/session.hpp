// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <stltsa.hpp>

#include "arguments.hpp"
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

    void add_file(const std::string& path, std::string content);
    /// As NPY or CSV, as the suffix says; the columns of a CSV are headed y1, y2 and so on.
    void add_table(const std::string& path, const stltsa::Matrix& table, const char* column = "y");
    /// Its format is told by the suffix. The clip must live until finish(), as a model must.
    void add_clip(const std::string& path, const stltsa::Clip& clip);
    void add_model(const std::string& path, const stltsa::Model& model);
    /// What finish() writes; only one of the two is asked for.
    struct Answer {
        std::function<std::string()> json;
        std::function<std::string()> table;
        std::vector<std::string> warnings;
    };
    /// Writes the JSON or, without --json, the table; then puts the files in their places.
    void finish(const Answer& answer);

  private:
    void warn(const std::vector<std::string>& warnings) const;
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
