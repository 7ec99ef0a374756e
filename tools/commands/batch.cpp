// SPDX-License-Identifier: BSD-3-Clause
// Decomposes many clips: one result for each, and a summary.
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "arguments/option_flags.hpp"
#include "arguments/pieces.hpp"
#include "batch/clips.hpp"
#include "batch/result.hpp"
#include "batch/summary.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/json.hpp"
#include "reports/table.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/progress_bar.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

namespace fs = std::filesystem;
using batch::ClipPath;
using batch::Row;

/// How the run gets on, on a terminal; ends it after Ctrl-C.
class Progress {
  public:
    Progress(bool shown, std::size_t clips) : bar_(shown), clips_(clips) {}

    void finished(const Row& row) {
        const std::lock_guard lock(mutex_);
        ++done_;
        failed_ += row.failed() ? 1 : 0;
        std::string label = fmt::format("{} of {} clips", done_, clips_);
        if (failed_ > 0)
            label += fmt::format(", {} failed", failed_);
        bar_.show(label, static_cast<double>(done_) / static_cast<double>(clips_));
    }

  private:
    std::mutex mutex_;
    ProgressBar bar_;
    std::size_t clips_;
    std::size_t done_ = 0;
    std::size_t failed_ = 0;
};

/// Decomposes clips into a folder. Safe to call from several threads, for different clips.
class Work {
  public:
    explicit Work(const Arguments& arguments)
        : arguments_(arguments), longest_(::pathconf(arguments.out.c_str(), _PC_NAME_MAX)) {}

    Row done(const ClipPath& clip) const {
        const std::string place = fmt::format("{}/{}", arguments_.out, clip.result);
        try {
            check_place(clip, place);
            const batch::Origin origin = origin_of(clip);
            if (const auto kept = batch::kept_result(place, origin)) {
                Row row = batch::row_of(clip.path, *kept);
                row.kept = true;
                return row;
            }
            const std::string result = result_of(clip);
            write(place, batch::with_origin(result, origin));
            return batch::row_of(clip.path, nlohmann::json::parse(result));
        } catch (const stltsa::Error& error) {
            stop_if_interrupted();
            return batch::failed_row(clip.path, error.name(), with_flags(error.what()));
        } catch (const Failure& failure) { // of a length in seconds
            stop_if_interrupted();
            return batch::failed_row(clip.path, stltsa::status_name(status_of(failure)),
                                     failure.what());
        } catch (const std::system_error& error) {
            return batch::failed_row(clip.path, stltsa::status_name(STLTSA_E_IO), error.what());
        }
    }

  private:
    static stltsa_status status_of(const Failure& failure) {
        if (failure.status() == Exit::failed) // the result cannot be written
            return STLTSA_E_IO;
        return failure.status() == Exit::unreadable ? STLTSA_E_FORMAT : STLTSA_E_ARGUMENT;
    }

    void check_place(const ClipPath& clip, const std::string& place) const {
        if (longest_ > 0 && std::ssize(clip.result) > longest_)
            throw Failure(
                Exit::failed,
                fmt::format("{}: the name of the result, this path with __ for /, would have {} "
                            "bytes, and a file name has at most {}: start the batch in a folder "
                            "nearer to the clip",
                            clip.path, clip.result.size(), longest_));
        if (!stltsa::clip::regular_or_new(stltsa::clip::followed(place)))
            throw Failure(Exit::failed, fmt::format("its result, {}, is not a file: remove it, or "
                                                    "give another --out",
                                                    place));
    }

    batch::Origin origin_of(const ClipPath& clip) const {
        const std::string file = file_of(clip.path);
        const auto skeleton = arguments_.options.find(STLTSA_OPT_SKELETON);
        const batch::Content content =
            batch::content_of(file, skeleton == arguments_.options.end() ? "" : skeleton->second);
        batch::Origin options = batch::Origin::object();
        for (const auto& [key, typed] : arguments_.options)
            if (key != STLTSA_OPT_THREADS) // results do not depend on it
                options[flag_of(key).substr(2)] = typed;
        return {{"source", batch::source_of(file, arguments_.out)},
                {"bytes", content.bytes},
                {"crc32", fmt::format("{:08x}", content.crc32)},
                {"options", options},
                {"library", stltsa::version()}};
    }

    std::string result_of(const ClipPath& path) const {
        stltsa::Options options;
        options.set(STLTSA_OPT_THREADS, std::int64_t{1}); // the jobs are threads
        options.set_progress([](std::int32_t, double) { return interrupted(); });
        set_options(options, arguments_.options);
        const stltsa::Clip clip = open(path.path, options);
        set_lengths(options, arguments_.options, working_rate(clip, options));
        return stltsa::decompose(clip, options).json();
    }

    /// --fps is for files that have no rate.
    stltsa::Clip open(const std::string& path, stltsa::Options& options) const {
        const auto fps = arguments_.options.find(STLTSA_OPT_FPS);
        options.unset(STLTSA_OPT_FPS);
        stltsa::Clip clip = stltsa::Clip::open_stretch(path, options);
        if (clip.fps() > 0 || fps == arguments_.options.end())
            return clip;
        set_options(options, {*fps});
        return stltsa::Clip::open_stretch(path, options);
    }

    static void write(const std::string& place, const std::string& text) {
        OutputFiles files;
        files.add(place, text);
        files.commit();
    }

    const Arguments& arguments_;
    long longest_; ///< name of a file in the folder of results, in bytes; -1: no limit
};

/// The rows in the order of the clips, made by several threads.
std::vector<Row> rows_of(const Work& work, const std::vector<ClipPath>& clips, int jobs,
                         Progress& progress) {
    std::vector<Row> rows(clips.size());
    std::atomic<std::size_t> next{0};
    std::exception_ptr problem;
    std::mutex mutex;
    const auto run = [&] {
        try {
            for (std::size_t i = next++; i < clips.size(); i = next++) {
                stop_if_interrupted();
                rows[i] = work.done(clips[i]);
                progress.finished(rows[i]);
            }
        } catch (...) {
            next = clips.size();
            const std::lock_guard lock(mutex);
            if (!problem)
                problem = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int i = 1; i < jobs; ++i)
            threads.emplace_back(run);
        run();
    }
    if (problem)
        std::rethrow_exception(problem);
    return rows;
}

std::string summary_place(const Arguments& arguments) {
    std::string part = arguments.shard;
    std::ranges::replace(part, '/', '-');
    return fmt::format("{}/summary{}{}.csv", arguments.out, part.empty() ? "" : "-", part);
}

/// The message without the path of the clip, whose name is beside it.
std::string without_path(const std::string& message, const std::string& path) {
    if (!message.starts_with(path + ':'))
        return message;
    const std::string rest = message.substr(path.size() + 1);
    return rest.starts_with(' ') ? rest.substr(1) : "line " + rest;
}

std::string report(const std::vector<Row>& rows, const std::string& place) {
    constexpr std::size_t most_rows = 60;
    const auto count = [&](auto which) { return std::ranges::count_if(rows, which); };
    const auto failed = static_cast<std::size_t>(count(std::mem_fn(&Row::failed)));
    std::string text =
        bold(fmt::format("{}: {} decomposed, {} kept from before, {} failed",
                         counted(std::ssize(rows), "clip"),
                         rows.size() - failed - static_cast<std::size_t>(count(&Row::kept)),
                         count(&Row::kept), failed)) +
        '\n';
    if (failed > 0)
        text += '\n';
    Facts facts;
    std::size_t listed = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].failed() && listed++ < most_rows)
            facts.add(one_line(rows[i].path),
                      without_path(one_line(rows[i].error), one_line(rows[i].path)));
    text += facts.text();
    if (failed > most_rows)
        text += fmt::format("  ... and {} more failed\n", failed - most_rows);
    return text + fmt::format("\nsummary: {}\n", place);
}

std::string report_json(const std::vector<Row>& rows, const std::string& place) {
    return JsonObject("format", "stltsa-batch/1", "clips", std::ssize(rows), "kept",
                      std::ranges::count_if(rows, &Row::kept), "failed",
                      std::ranges::count_if(rows, std::mem_fn(&Row::failed)), "summary", place)
               .text() +
           '\n';
}

} // namespace

Exit run_batch(const Arguments& arguments) {
    const batch::Shard shard =
        arguments.shard.empty() ? batch::Shard{} : batch::parse_shard(arguments.shard);
    const batch::Found found = batch::find_clips(arguments.pieces, arguments.out);
    const std::vector<ClipPath> clips = batch::clips_of(shard, found.clips);
    stltsa::Options checked;
    set_options(checked, arguments.options); // a wrong option fails once, not for each clip
    std::error_code error;
    fs::create_directories(arguments.out, error);
    if (error)
        throw Failure(Exit::failed,
                      fmt::format("cannot create {}: {}", arguments.out, error.message()));
    const std::string place = summary_place(arguments);
    check_output_place(place, {}); // or else each clip would fail
    Progress progress(!arguments.quiet && obeys_codes(STDERR_FILENO), clips.size());
    const std::vector<Row> rows = rows_of(Work(arguments), clips, arguments.jobs, progress);
    OutputFiles files;
    files.add(place, batch::summary_csv(rows));
    files.commit();
    write_stdout(arguments.json ? report_json(rows, place)
                                : shown(report(rows, place),
                                        colors_wanted(STDOUT_FILENO, !arguments.no_color)));
    if (found.foreign > 0 && !arguments.quiet)
        print_message("warning: " + batch::left_out(found.foreign), Tone::warning,
                      !arguments.no_color);
    return std::ranges::any_of(rows, std::mem_fn(&Row::failed)) ? Exit::partly : Exit::done;
}

} // namespace tool
