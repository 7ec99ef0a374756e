// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <memory>
#include <span>

#include <unistd.h>

#include "capi/batch/clips.hpp"
#include "capi/batch/result.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/boundary/structs.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"
#include "clip/files/replace_file.hpp"
#include "clip/files/write_file.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

struct stltsa_batch {
    std::string folder;
    std::string summary; ///< path of the table
    std::vector<std::string> clips;
    stltsa_options options;
};

namespace {

namespace batch = capi::batch;
namespace fs = std::filesystem;

std::string summary_place(const std::string& folder, std::string part) {
    std::ranges::replace(part, '/', '-');
    return format_text("{}/summary{}{}.csv", folder, part.empty() ? "" : "-", part);
}

/// Throws now, or else each clip would fail.
void check_folder(const stltsa_batch& batch) {
    std::error_code error;
    fs::create_directories(batch.folder, error);
    if (error == std::errc::not_enough_memory)
        throw std::bad_alloc();
    if (error)
        fail(Status::io, "cannot create {}: {}", batch.folder, error.message());
    if (fs::is_directory(batch.summary, error))
        fail(Status::io, "{}: cannot write: it is a folder", batch.summary);
    try {
        clip::TemporaryFile(batch.folder + "/results");
    } catch (const std::system_error& problem) {
        if (problem.code() == std::errc::not_enough_memory)
            throw std::bad_alloc();
        fail(Status::io, "{}: cannot write into this folder: {}", batch.folder,
             problem.code().message());
    }
}

void check_place(const std::string& folder, const std::string& name, const std::string& place) {
    const long most = ::pathconf(folder.c_str(), _PC_NAME_MAX); // -1: no limit
    if (most > 0 && std::ssize(name) > most)
        fail(Status::io,
             "the name of the result, the path of the clip with __ for /, would have {} bytes, and "
             "a file name has at most {}: start the batch in a folder nearer to the clip",
             name.size(), most);
    if (!clip::regular_or_new(clip::followed(place)))
        fail(Status::io,
             "its result, {}, is not a file: remove it, or give another folder of results", place);
}

std::string decomposed(const std::string& path, const stltsa_clip* given,
                       const stltsa_options& options) {
    const capi::OptionsReader reader(&options);
    const auto opened =
        given == nullptr ? capi::read_path(path, reader, clip::read_at_own_rate) : nullptr;
    return capi::decomposition_json(
        results::decompose(given == nullptr ? opened->clip : given->clip, reader.prepare_options(),
                           reader.decompose_options()));
}

struct Done {
    std::string row;
    bool kept = false;
};

Done done(const stltsa_batch& of, const std::string& path, const stltsa_clip* given) {
    const std::string name = batch::result_name(path), place = of.folder + '/' + name;
    check_place(of.folder, name, place);
    const batch::Origin origin = batch::origin_of(path, of.folder, of.options);
    if (const auto kept = batch::kept_result(place, origin))
        return {batch::row_of(path, *kept), true};
    const std::string result = decomposed(path, given, of.options);
    clip::write_file(place, batch::with_origin(result, origin));
    return {batch::row_of(path, result)};
}

const std::string* clip_at(const stltsa_batch& batch, std::int64_t index) {
    return index < 0 || index >= std::ssize(batch.clips)
               ? nullptr
               : &batch.clips[static_cast<std::size_t>(index)];
}

template <class T>
std::span<const T> list_of(const T* list, std::int64_t count, const char* name) {
    if (count < 0)
        fail(Status::argument, "the number of {} is {}", name, count);
    if (count > 0)
        required(list, name);
    for (std::int64_t i = 0; i < count; ++i)
        required(list[i], name);
    return {list, static_cast<std::size_t>(count)};
}

} // namespace

stltsa_status stltsa_batch_new(const char* const* paths, int64_t count, const char* folder,
                               const char* shard, const stltsa_options* options,
                               stltsa_batch** made) noexcept {
    return guard([&] {
        required(made, "batch") = nullptr;
        const std::string out = &required(folder, "folder");
        const capi::OptionsReader reader(options);
        reader.prepare_options(), reader.decompose_options(); // a wrong one fails once
        auto clips = batch::find_clips(list_of(paths, count, "paths"));
        if (shard != nullptr)
            clips = batch::part_of(clips, shard);
        auto plan = std::make_unique<stltsa_batch>(
            stltsa_batch{out, summary_place(out, shard == nullptr ? "" : shard), std::move(clips),
                         options == nullptr ? stltsa_options{} : *options});
        check_folder(*plan);
        *made = plan.release();
    });
}

void stltsa_batch_free(stltsa_batch* batch) noexcept {
    delete batch;
}

const char* stltsa_batch_path(const stltsa_batch* batch, int64_t index) noexcept {
    const std::string* path = batch == nullptr ? nullptr : clip_at(*batch, index);
    return path == nullptr ? nullptr : path->c_str();
}

stltsa_status stltsa_batch_run(const stltsa_batch* batch, int64_t index, const stltsa_clip* clip,
                               const stltsa_options* options, int32_t* kept, char** row) noexcept {
    const std::string* path = nullptr;
    stltsa_status status = guard([&] {
        required(row, "row") = nullptr;
        path = clip_at(required(batch, "batch"), index);
        if (path == nullptr)
            fail(Status::argument, "clip {}: the batch has {} clips", index, batch->clips.size());
    });
    if (status != STLTSA_OK)
        return status;
    status = capi::compute(options, [&] {
        const Done one = done(*batch, *path, clip);
        *row = capi::caller_string(one.row);
        if (kept != nullptr)
            *kept = one.kept ? 1 : 0;
    });
    if (status == STLTSA_OK || status == STLTSA_E_CANCELLED)
        return status;
    const stltsa_status told = guard([&] {
        *row = capi::caller_string(capi::batch::failed_row(*path, status, stltsa_last_error()));
        if (kept != nullptr)
            *kept = 0;
    });
    return told == STLTSA_OK ? status : told;
}

stltsa_status stltsa_batch_finish(const stltsa_batch* batch, const char* const* rows, int64_t count,
                                  const char** summary) noexcept {
    return guard([&] {
        const std::string& place = required(batch, "batch").summary;
        std::string text(capi::batch::summary_head);
        for (const char* row : list_of(rows, count, "rows"))
            text += row;
        clip::write_file(place, text);
        if (summary != nullptr)
            *summary = place.c_str();
    });
}
