// SPDX-License-Identifier: BSD-3-Clause
#include "capi/source.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "capi/guard.hpp"
#include "clip/prepare.hpp"
#include "motion/choose_neighbors.hpp"

namespace stltsa::capi {

char* caller_string(const std::string& text) {
    char* copy = new char[text.size() + 1];
    std::memcpy(copy, text.c_str(), text.size() + 1);
    return copy;
}

Source matrix_source(ConstMatrixView frames, const OptionsReader& options) {
    Source source;
    source.samples.count = frames.rows;
    source.samples.fps = options.real(STLTSA_OPT_FPS);
    source.samples.feature_count = frames.cols;
    return source;
}

namespace {

/// With fewer the blame is on the decimation, not on the clip.
constexpr std::int64_t least_samples = 4;

/// Relative difference of sample rates that counts as none: 29.97 and 30 a second do. The k of the
/// default window, 36 at 30 a second, is then off by less than one.
constexpr double same_rate = 0.01;

ClipSamples prepare_clip(const clip::Clip& clip, const clip::PrepareOptions& prepare) {
    clip::Prepared prepared = clip::prepare(clip, prepare);
    if (prepared.step > 1 && prepared.samples.rows() < least_samples)
        fail(Status::too_few_frames,
             "of {} frames at {} a second one in {} is kept, which leaves {}; at least {} are "
             "needed: check the frame rate, or set option sample_rate to 0 to keep all",
             clip.values.rows(), clip.fps, prepared.step, prepared.samples.rows(), least_samples);
    ClipSamples result;
    result.source.clips = {clip_facts(clip)};
    result.source.clips.front().first = prepared.first;
    result.source.clips.front().step = prepared.step;
    result.source.samples = {prepared.samples.rows(),
                             prepared.first,
                             prepared.step,
                             prepared.fps,
                             prepared.features,
                             prepared.samples.cols(),
                             prepared.up,
                             clip.fps > 0 ? prepare.smoothing : 0};
    result.lengths = {prepared.samples.rows()};
    result.samples = std::move(prepared.samples);
    result.jump = prepared.jump;
    return result;
}

void check_same_kind(const clip::Clip& first, const clip::Clip& other, std::size_t index) {
    if (first.skeleton.has_value() != other.skeleton.has_value())
        fail(Status::shape, "of clips[{}] and clips[0] only one has a skeleton", index);
    if (first.skeleton && !clip::same_hierarchy(*first.skeleton, *other.skeleton))
        fail(Status::shape,
             "clips[{}] has other joints or channels than clips[0]: fit clips of one hierarchy",
             index);
}

void check_same_samples(const SampleFacts& first, const SampleFacts& other, std::size_t index) {
    if (other.feature_count != first.feature_count)
        fail(Status::shape, "clips[{}] has {} features, clips[0] has {}", index,
             other.feature_count, first.feature_count);
    if (!(std::abs(other.fps - first.fps) <= same_rate * first.fps))
        fail(Status::shape,
             "clips[{}] has {} samples a second, clips[0] has {}: set option sample_rate to a rate "
             "that both can be decimated to",
             index, other.fps, first.fps);
}

Matrix stacked(const std::vector<Matrix>& parts, std::int64_t rows) {
    Matrix all(rows, parts.front().cols());
    double* to = all.data();
    for (const Matrix& part : parts)
        to = std::copy_n(part.data(), part.rows() * part.cols(), to);
    return all;
}

} // namespace

ClipSamples prepare_clips(std::span<const stltsa_clip* const> clips, const OptionsReader& options) {
    clip::PrepareOptions prepare = options.prepare_options();
    const auto report = [&](std::size_t done) {
        options.progress().report(Stage::features,
                                  static_cast<double>(done) / static_cast<double>(clips.size()));
    };
    report(0);
    const clip::Clip& first = clips.front()->clip;
    ClipSamples all = prepare_clip(first, prepare);
    report(1);
    if (clips.size() == 1)
        return all;
    prepare.up = all.source.samples.up;
    std::vector<Matrix> parts;
    parts.push_back(std::move(all.samples));
    for (std::size_t c = 1; c < clips.size(); ++c) {
        check_same_kind(first, clips[c]->clip, c);
        ClipSamples next = prepare_clip(clips[c]->clip, prepare);
        check_same_samples(all.source.samples, next.source.samples, c);
        all.source.clips.push_back(next.source.clips.front());
        all.source.samples.count += next.source.samples.count;
        all.lengths.push_back(next.samples.rows());
        parts.push_back(std::move(next.samples));
        report(c + 1);
    }
    all.samples = stacked(parts, all.source.samples.count);
    return all;
}

std::span<const stltsa_clip* const> clips_of(const stltsa_clip* const* clips, std::int64_t count) {
    if (count < 1)
        fail(Status::argument, "count is {}: at least one clip is needed", count);
    const std::span all(&required(clips, "clips"), static_cast<std::size_t>(count));
    for (std::size_t c = 0; c < all.size(); ++c)
        if (all[c] == nullptr)
            fail(Status::argument, "clips[{}] is NULL", c);
    return all;
}

namespace {

motion::Period find_period(ConstMatrixView samples, const OptionsReader& options, Source& source) {
    const double fps = source.samples.fps;
    if (!(fps > 0))
        return {};
    const auto search = options.decompose_options();
    const motion::Period found = motion::find_period(samples, fps, search.shortest_period,
                                                     search.longest_period, options.progress());
    source.period = {found.samples / fps, found.quality, search.shortest_period,
                     search.longest_period};
    return found;
}

/// Neighbors are looked for within a clip, so that the shortest one limits their number.
std::int64_t distinct_in_reach(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                               ltsa::Mode mode) {
    if (mode == ltsa::Mode::spatial)
        return motion::distinct_frames(samples);
    std::int64_t least = samples.rows;
    std::int64_t first = 0;
    for (const std::int64_t length : lengths) {
        least = std::min(least, motion::distinct_frames(samples.block(first, length)));
        first += length;
    }
    return least;
}

} // namespace

ltsa::Parameters choose_parameters(ConstMatrixView samples, std::span<const std::int64_t> lengths,
                                   const OptionsReader& options, int standard_dimension,
                                   Source& source) {
    ltsa::Parameters p;
    const auto dimension = static_cast<int>(options.integer(STLTSA_OPT_DIMENSION));
    p.dimension = dimension > 0 ? dimension : standard_dimension;
    p.mode = static_cast<ltsa::Mode>(options.integer(STLTSA_OPT_MODE));
    p.include_self = options.integer(STLTSA_OPT_INCLUDE_SELF) != 0;
    p.links = options.integer(STLTSA_OPT_LINKS);
    p.threads = options.threads();
    p.neighbors = options.integer(STLTSA_OPT_NEIGHBORS);
    if (p.neighbors == 0)
        p.neighbors = motion::choose_neighbors(
            find_period(samples, options, source), source.samples.fps,
            {distinct_in_reach(samples, lengths, p.mode), p.dimension, p.dimension});
    const std::int64_t window = options.integer(STLTSA_OPT_WINDOW);
    p.window = window > 0 ? window : p.neighbors;
    const std::int64_t exclusion = options.integer(STLTSA_OPT_EXCLUSION);
    p.exclusion = exclusion > 0 ? exclusion : p.window;
    return p;
}

} // namespace stltsa::capi
