// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>
#include <string_view>

#include "base/progress.hpp"
#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/boundary/structs.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"
#include "clip/arrays/mirror.hpp"
#include "clip/features/features.hpp"
#include "clip/stretch.hpp"
#include "clip/text/text_cursor.hpp"
#include "clip/write.hpp"
#include "ltsa/frames.hpp"
#include "results/stretches.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

namespace {

constexpr bool same(clip::Format format, int value) {
    return static_cast<int>(format) == value;
}
static_assert(
    same(clip::Format::bvh, STLTSA_FORMAT_BVH) && same(clip::Format::amc, STLTSA_FORMAT_AMC) &&
    same(clip::Format::csv, STLTSA_FORMAT_CSV) && same(clip::Format::npy, STLTSA_FORMAT_NPY) &&
    same(clip::Format::matrix, STLTSA_FORMAT_MATRIX) &&
    same(clip::Format::points, STLTSA_FORMAT_POINTS) &&
    same(clip::Format::skeleton, STLTSA_FORMAT_SKELETON) &&
    same(clip::Format::glb, STLTSA_FORMAT_GLB) && same(clip::Format::c3d, STLTSA_FORMAT_C3D) &&
    same(clip::Format::trc, STLTSA_FORMAT_TRC) && same(clip::Format::mot, STLTSA_FORMAT_MOT));

Matrix clip_features(const stltsa_clip& clip, const stltsa_options* options) {
    const auto prepare = capi::OptionsReader(options).prepare_options();
    return clip::feature_rows(clip.clip, prepare.features, prepare.up, prepare.gaps).rows;
}

std::vector<clip::Frames> find(const clip::Clip& clip, const std::string& what,
                               const capi::OptionsReader& reader) {
    const auto stretch = clip::parse_stretch(what);
    if (!stretch)
        fail(Status::argument, "{} is no stretch of a clip: there are {}", clip::in_quotes(what),
             clip::stretch_forms);
    return results::find_stretches(clip, *stretch, [&] {
        return results::decompose(clip, reader.prepare_options(), reader.decompose_options());
    });
}

/// The frames of the file that these frames of the clip are.
std::vector<clip::Frames> pieces_of(const stltsa_clip& clip,
                                    const std::vector<clip::Frames>& stretches) {
    if (clip.pieces.empty())
        return stretches;
    std::vector<clip::Frames> pieces;
    for (const clip::Frames& stretch : stretches) {
        std::int64_t at = 0; // of the piece in the clip
        for (const clip::Frames& piece : clip.pieces) {
            const std::int64_t moved = piece.begin - at;
            const clip::Frames part{std::max(piece.begin, stretch.begin + moved),
                                    std::min(piece.end, stretch.end + moved)};
            if (part.begin < part.end)
                pieces.push_back(part);
            at += piece.count();
        }
    }
    return pieces;
}

std::unique_ptr<stltsa_clip> cut(const stltsa_clip& whole, const std::string& what,
                                 const capi::OptionsReader& reader) {
    const auto stretches = find(whole.clip, what, reader);
    auto made = std::make_unique<stltsa_clip>(clip::cut(whole.clip, stretches));
    made->pieces = pieces_of(whole, stretches);
    if (whole.pieces.empty())
        made->stretch = what;
    else if (made->pieces.size() == 1)
        made->stretch = format_text("{}-{}", made->pieces[0].begin, made->pieces[0].end);
    return made;
}

clip::Format format_of(int32_t format, std::string_view bytes) {
    return format == 0 ? clip::sniff(bytes) : static_cast<clip::Format>(format);
}

} // namespace

std::unique_ptr<stltsa_clip> capi::read_path(const std::string& text, const OptionsReader& reader,
                                             clip::Clip (*read)(const std::string& path,
                                                                const clip::ReadOptions&)) {
    const auto [path, what] = clip::split_stretch(text);
    auto made = std::make_unique<stltsa_clip>(read(path, reader.read_options()));
    if (what.empty())
        return made;
    try {
        return cut(*made, what, reader);
    } catch (const Error& error) {
        fail(error.status(), "{}: {}", text, error.what());
    }
}

stltsa_status stltsa_clip_open(const char* path, const stltsa_options* options,
                               stltsa_clip** clip) noexcept {
    return compute(options, [&] {
        required(clip, "clip") = nullptr;
        const capi::OptionsReader reader(options);
        report_progress(Stage::read, 0);
        auto made = std::make_unique<stltsa_clip>(
            clip::read(&required(path, "path"), reader.read_options()));
        report_progress(Stage::read, 1);
        *clip = made.release();
    });
}

stltsa_status stltsa_clip_open_stretch(const char* text, const stltsa_options* options,
                                       stltsa_clip** clip) noexcept {
    return compute(options, [&] {
        required(clip, "clip") = nullptr;
        const capi::OptionsReader reader(options);
        report_progress(Stage::read, 0);
        auto made = capi::read_path(&required(text, "text"), reader);
        report_progress(Stage::read, 1);
        *clip = made.release();
    });
}

stltsa_status stltsa_clip_parse(const void* bytes, size_t size, int32_t format, const char* name,
                                const stltsa_options* options, stltsa_clip** clip) noexcept {
    return guard(options, [&] {
        required(clip, "clip") = nullptr;
        const auto* text = static_cast<const char*>(bytes);
        if (size > 0)
            required(text, "bytes");
        const std::string_view all(text, size);
        const capi::OptionsReader reader(options);
        report_progress(Stage::read, 0);
        const std::string path = name == nullptr ? "" : name;
        clip::Clip whole = clip::parse(all, format_of(format, all), path.empty() ? "memory" : path,
                                       reader.read_options());
        whole.path = path;
        auto made = std::make_unique<stltsa_clip>(std::move(whole));
        report_progress(Stage::read, 1);
        *clip = made.release();
    });
}

stltsa_status stltsa_clip_from_matrix(const stltsa_in* frames, double fps,
                                      stltsa_clip** clip) noexcept {
    return guard([&] {
        required(clip, "clip") = nullptr;
        const capi::InputFrames input(frames, "frames");
        capi::check_rate(fps);
        auto made = std::make_unique<stltsa_clip>();
        made->clip.fps = fps;
        const std::int64_t rows = input.view().rows;
        ltsa::check_frames(input.view(), {&rows, 1});
        made->clip.values = copied(input.view());
        *clip = made.release();
    });
}

stltsa_status stltsa_clip_stretch(const stltsa_clip* clip, const char* what,
                                  const stltsa_options* options, stltsa_clip** stretch) noexcept {
    return compute(options, [&] {
        required(stretch, "stretch") = nullptr;
        const stltsa_clip& whole = required(clip, "clip");
        const std::string typed = &required(what, "what");
        *stretch = cut(whole, typed, capi::OptionsReader(options)).release();
    });
}

stltsa_status stltsa_clip_set_path(stltsa_clip* clip, const char* path) noexcept {
    return guard([&] { required(clip, "clip").clip.path = path == nullptr ? "" : path; });
}

stltsa_status stltsa_clip_mirror(const stltsa_clip* clip, const stltsa_options* options,
                                 stltsa_clip** mirrored) noexcept {
    return guard(options, [&] {
        required(mirrored, "mirrored") = nullptr;
        auto made = std::make_unique<stltsa_clip>(clip::mirrored(
            required(clip, "clip").clip, capi::OptionsReader(options).prepare_options().up));
        *mirrored = made.release();
    });
}

stltsa_status stltsa_clip_find(const stltsa_clip* clip, const char* what,
                               const stltsa_options* options, int64_t capacity,
                               stltsa_interval* intervals, int64_t* count) noexcept {
    return compute(options, [&] {
        required(count, "count") = 0;
        const clip::Clip& whole = required(clip, "clip").clip;
        const auto found = find(whole, &required(what, "what"), capi::OptionsReader(options));
        for (std::int64_t i = 0; i < std::min(capacity, std::ssize(found)); ++i) {
            const clip::Frames& frames = found[static_cast<std::size_t>(i)];
            const auto seconds = [&](std::int64_t frame) {
                return whole.fps > 0 ? static_cast<double>(frame) / whole.fps : 0;
            };
            (&required(intervals, "intervals"))[i] = {frames.begin, frames.end,
                                                      seconds(frames.begin), seconds(frames.end)};
        }
        *count = std::ssize(found);
    });
}

void stltsa_clip_free(stltsa_clip* clip) noexcept {
    delete clip;
}

int64_t stltsa_clip_frames(const stltsa_clip* clip) noexcept {
    return clip == nullptr ? 0 : clip->clip.frames();
}

double stltsa_clip_fps(const stltsa_clip* clip) noexcept {
    return clip == nullptr ? 0 : clip->clip.fps;
}

stltsa_status stltsa_clip_feature_count(const stltsa_clip* clip, const stltsa_options* options,
                                        int64_t* count) noexcept {
    return compute(options, [&] {
        const auto prepare = capi::OptionsReader(options).prepare_options();
        required(count, "count") =
            clip::feature_count(required(clip, "clip").clip, prepare.features);
    });
}

stltsa_status stltsa_clip_features(const stltsa_clip* clip, const stltsa_options* options,
                                   const stltsa_out* features) noexcept {
    return compute(options, [&] {
        capi::write_output(features, "features",
                           clip_features(required(clip, "clip"), options).view());
    });
}

stltsa_status stltsa_clip_save(const stltsa_clip* clip, const char* path,
                               const stltsa_options* options) noexcept {
    return guard(options,
                 [&] { clip::write(required(clip, "clip").clip, &required(path, "path")); });
}
