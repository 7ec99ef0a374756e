// SPDX-License-Identifier: BSD-3-Clause
// Decomposes many clips with several threads, and says how that went.
#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "arguments/option_flags.hpp"
#include "commands/commands.hpp"
#include "exit_status.hpp"
#include "reports/json.hpp"
#include "reports/table.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/progress_bar.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

using Rows = std::vector<stltsa::BatchRow>;

std::int64_t kept_in(const Rows& rows) {
    return std::ranges::count_if(rows, &stltsa::BatchRow::kept);
}

std::int64_t failed_in(const Rows& rows) {
    return std::ranges::count_if(rows, [](const auto& row) { return row.status != STLTSA_OK; });
}

/// The rows in the order of the clips, made by several threads; until Ctrl-C.
Rows rows_of(const stltsa::Batch& batch, std::size_t clips, int jobs, bool shown) {
    Rows rows(clips);
    ProgressBar bar(shown);
    std::size_t done = 0, failed = 0;
    std::atomic<std::size_t> next{0};
    std::exception_ptr problem;
    std::mutex mutex;
    const auto show = [&](const stltsa::BatchRow& row) {
        const std::lock_guard lock(mutex);
        ++done;
        failed += row.status == STLTSA_OK ? 0 : 1;
        bar.show(fmt::format("{} of {} clips{}", done, clips,
                             failed > 0 ? fmt::format(", {} failed", failed) : ""),
                 static_cast<double>(done) / static_cast<double>(clips));
    };
    const auto run = [&] {
        try {
            stltsa::Options options;
            options.set_progress([](std::int32_t, double) { return interrupted(); });
            for (std::size_t i = next++; i < clips; i = next++) {
                stop_if_interrupted();
                rows[i] = batch.run(static_cast<std::int64_t>(i), options);
                show(rows[i]);
            }
        } catch (...) {
            next = clips;
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

/// The message without the path of the clip, whose name is beside it.
std::string without_path(const std::string& message, const std::string& path) {
    if (!message.starts_with(path + ':'))
        return message;
    const std::string rest = message.substr(path.size() + 1);
    return rest.starts_with(' ') ? rest.substr(1) : "line " + rest;
}

std::string report(const std::vector<std::string>& paths, const Rows& rows,
                   const std::string& summary) {
    constexpr std::int64_t most_rows = 60;
    const std::int64_t kept = kept_in(rows), failed = failed_in(rows);
    std::string text = bold(fmt::format("{}: {} decomposed, {} kept from before, {} failed",
                                        counted(std::ssize(rows), "clip"),
                                        std::ssize(rows) - failed - kept, kept, failed)) +
                       (failed > 0 ? "\n\n" : "\n");
    Facts facts;
    std::int64_t listed = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].status != STLTSA_OK && listed++ < most_rows)
            facts.add(one_line(paths[i]),
                      without_path(one_line(with_flags(rows[i].error)), one_line(paths[i])));
    text += facts.text();
    if (failed > most_rows)
        text += fmt::format("  ... and {} more failed\n", failed - most_rows);
    return text + fmt::format("\nsummary: {}\n", summary);
}

std::string report_json(const Rows& rows, const std::string& summary) {
    return JsonObject("format", "stltsa-batch/1", "clips", std::ssize(rows), "kept", kept_in(rows),
                      "failed", failed_in(rows), "summary", summary)
               .text() +
           '\n';
}

/// Calls `work`; what cannot be written is no unreadable input.
template <class Work>
auto writing(Work work) {
    try {
        return work();
    } catch (const stltsa::Error& error) {
        throw error.status() == STLTSA_E_IO ? Failure(Exit::failed, error.what()) : Failure(error);
    }
}

} // namespace

Exit run_batch(const Arguments& arguments) {
    stltsa::Options options;
    set_options(options, arguments.options);
    const stltsa::Batch batch = writing(
        [&] { return stltsa::Batch(arguments.pieces, arguments.out, arguments.shard, options); });
    const std::vector<std::string> paths = batch.paths();
    const Rows rows = rows_of(batch, paths.size(), arguments.jobs,
                              !arguments.quiet && obeys_codes(STDERR_FILENO));
    std::vector<std::string> texts;
    for (const stltsa::BatchRow& row : rows)
        texts.push_back(row.text);
    const std::string summary = writing([&] { return batch.finish(texts); });
    write_stdout(arguments.json ? report_json(rows, summary)
                                : shown(report(paths, rows, summary),
                                        colors_wanted(STDOUT_FILENO, !arguments.no_color)));
    return failed_in(rows) > 0 ? Exit::partly : Exit::done;
}

} // namespace tool
