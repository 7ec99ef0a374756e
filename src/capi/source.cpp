// SPDX-License-Identifier: BSD-3-Clause
#include "capi/source.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

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

} // namespace

ClipSamples prepare_clip(const stltsa_clip& clip, const OptionsReader& options) {
    const auto prepare = options.prepare_options();
    options.progress().report(Stage::features, 0);
    clip::Prepared prepared = clip::prepare(clip.clip, prepare);
    options.progress().report(Stage::features, 1);
    if (prepared.step > 1 && prepared.samples.rows() < least_samples)
        fail(Status::too_few_frames,
             "of {} frames at {} a second one in {} is kept, which leaves {}; at least {} are "
             "needed: check the frame rate, or set option sample_rate to 0 to keep all",
             clip.clip.values.rows(), clip.clip.fps, prepared.step, prepared.samples.rows(),
             least_samples);
    ClipSamples result;
    result.source.from_clip = true;
    result.source.clip = clip_facts(clip.clip);
    result.source.samples = {prepared.samples.rows(),
                             prepared.first,
                             prepared.step,
                             prepared.fps,
                             prepared.features,
                             prepared.samples.cols(),
                             prepared.up,
                             clip.clip.fps > 0 ? prepare.smoothing : 0};
    result.samples = std::move(prepared.samples);
    result.jump = prepared.jump;
    return result;
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
