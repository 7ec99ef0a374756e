// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <stltsa.hpp>

#include "arguments/arguments.hpp"
#include "terminal/output.hpp"
#include "terminal/progress_bar.hpp"

namespace tool {

/// Rate of the working samples, to which lengths in seconds are converted.
double working_rate(const stltsa::Clip& clip, const stltsa::Options& options);

/// Common to all commands: sets options, reads the input, writes the result. Throws Failure.
class Session {
  public:
    /// Sets the options, and refuses destinations where no file can be created.
    explicit Session(const Arguments& arguments);

    /// Opens arguments.input, and converts lengths given in seconds to its frames.
    const stltsa::Clip& open_input();
    const stltsa::Clip& clip() const { return *clip_; }
    stltsa::Clip open_clip(const std::string& path) const;
    stltsa::Model open_model(const std::string& path) const;

    /// Whether arguments.input is a model, by its name or by the first bytes of standard input.
    bool input_is_model() const;

    /// Sets the option fps to the rate of a file.
    void set_fps(double fps);
    const stltsa::Options& options() const { return options_; }
    /// Sets an option that was not typed.
    void set_default(std::int32_t key, std::int64_t value);
    const Arguments& arguments() const { return arguments_; }

    /// The file's name without its folder.
    std::string title() const;
    static std::string title_of(const std::string& path);

    void add_file(const std::string& path, std::string content);
    /// As NPY or CSV, by suffix; the columns of a CSV file are named y1, y2 and so on. If the rate
    /// is known, a column of seconds comes first.
    void add_table(const std::string& path, const stltsa::Matrix& table, const char* column = "y",
                   double fps = 0);
    /// The same with a name for each column; NaN is an empty cell of CSV.
    void add_columns(const std::string& path, const stltsa::Matrix& table,
                     const std::vector<const char*>& names);
    /// The suffix determines the format. The clip, like a model, must live until finish().
    void add_clip(const std::string& path, const stltsa::Clip& clip);
    void add_model(const std::string& path, const stltsa::Model& model);
    /// Adds a file, which `save` writes under a given name with this suffix.
    void add_saved(const std::string& path, const char* suffix,
                   std::function<void(const std::string&)> save);
    /// The result that finish() writes, as JSON or as a table; only one is called.
    struct Answer {
        std::function<std::string()> json;
        std::function<std::string()> table;
        std::vector<std::string> warnings;
        std::function<std::string()> csv = {}; ///< empty: there is none
        std::vector<std::string> notes = {};   ///< assumptions that the result depends on
    };
    /// Writes the JSON or, without --json, the table, or the CSV if --output ends in .csv; then
    /// moves the files to their destinations. If a file of the run goes to standard output, the
    /// table does not.
    void finish(const Answer& answer);

  private:
    stltsa::Clip parse_stdin(const std::string& what) const;
    void add_skeleton(const std::string& temporary, const std::string& amc);
    /// Where the JSON or the table goes; empty: nowhere.
    std::string text_place() const;
    bool table_is_seen() const;
    std::string text_of(const Answer& answer) const;
    void tell(const std::vector<std::string>& texts, const char* kind) const;
    /// Reads standard input on the first call.
    const std::string& standard_input() const;

    const Arguments& arguments_;
    ProgressBar bar_;
    stltsa::Options options_;
    std::optional<stltsa::Clip> clip_;
    mutable std::optional<std::string> standard_input_;
    OutputFiles files_;
};

} // namespace tool
