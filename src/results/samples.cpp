// SPDX-License-Identifier: BSD-3-Clause
#include "results/samples.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/progress.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/column_owners.hpp"
#include "clip/features/point_sides.hpp"
#include "linalg/principal.hpp"
#include "linalg/simd.hpp"

namespace stltsa::results {
namespace {

/// If decimation leaves fewer samples than this, the message is about the decimation.
constexpr std::int64_t least_samples = 4;

/// Sample rates with a smaller relative difference are taken as equal, such as 29.97 and 30 Hz. The
/// default k, 36 at 30 Hz, then changes by less than one.
constexpr double same_rate = 0.01;

/// Breaks, and the middles of holes, divide the samples. A hole at an end has nothing beyond it.
std::vector<std::int64_t> runs_of(const clip::Prepared& prepared, std::int64_t frames) {
    std::vector<std::int64_t> runs;
    std::int64_t begin = 0;
    for (const clip::Frames& hole : prepared.holes) {
        const std::int64_t from_first = (hole.begin + hole.end) / 2 - prepared.first;
        const std::int64_t row = (from_first + prepared.step - 1) / prepared.step;
        if (hole.begin <= prepared.first || hole.end >= frames || row <= begin ||
            row >= prepared.samples.rows())
            continue;
        runs.push_back(row - begin);
        begin = row;
    }
    runs.push_back(prepared.samples.rows() - begin);
    return runs;
}

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
    std::ranges::move(prepared.notes, std::back_inserter(result.source.clips.front().notes));
    result.source.samples = {prepared.samples.rows(),
                             prepared.first,
                             prepared.step,
                             prepared.fps,
                             prepared.features,
                             prepared.samples.cols(),
                             prepared.up,
                             clip.fps > 0 ? prepare.smoothing : 0};
    result.lengths = {{prepared.samples.rows()}, runs_of(prepared, clip.frames())};
    result.samples = std::move(prepared.samples);
    result.rows = std::move(prepared.rows);
    result.jump = prepared.jump;
    result.turned = prepared.turned;
    result.holes = std::move(prepared.holes);
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

ClipSamples prepare_clips(Clips clips, clip::PrepareOptions options) {
    const auto report = [&](std::size_t prepared) {
        report_progress(Stage::features,
                        static_cast<double>(prepared) / static_cast<double>(clips.size()));
    };
    std::size_t done = 0;
    report(done);
    ClipSamples all = prepare_clip(*clips.front(), options);
    report(++done);
    if (clips.size() == 1)
        return all;
    options.features = all.source.samples.features;
    options.up = all.source.samples.up;
    std::vector<Matrix> parts;
    parts.push_back(std::move(all.samples));
    for (std::size_t c = 1; c < clips.size(); ++c) {
        check_same_kind(*clips.front(), *clips[c], c);
        ClipSamples next = prepare_clip(*clips[c], options);
        check_same_samples(all.source.samples, next.source.samples, c);
        all.source.clips.push_back(next.source.clips.front());
        all.source.samples.count += next.source.samples.count;
        all.lengths.clips.push_back(next.samples.rows());
        std::ranges::copy(next.lengths.runs, std::back_inserter(all.lengths.runs));
        parts.push_back(std::move(next.samples));
        report(++done);
    }
    all.samples = stacked(parts, all.source.samples.count);
    return all;
}

BodySides body_sides(const clip::Clip& clip, const SampleFacts& facts, ConstMatrixView samples) {
    BodySides sides;
    sides.weights = facts.features == clip::Features::points
                        ? clip::point_side_weights(clip, facts.up, samples)
                        : clip::side_weights(clip, facts.features, facts.up, samples);
    if (sides.weights.empty())
        return sides;
    const std::vector<Sided> names = sides_of(clip::column_owners(clip, facts.features));
    const std::vector<double> means = column_means(samples);
    sides.one.resize(sides.weights.size());
    sides.other.resize(sides.weights.size());
    const double* direction = nullptr; // the weights of one side
    int lefts = 0;                     // names that say that this side is left, less the others
    double places[2][3] = {}, counts[2] = {}; // sums of the named points on the left and the right
    for (std::size_t c = 0; c + 2 < sides.weights.size(); c += 3) {
        const double* weight = &sides.weights[c];
        if (dot(weight, weight, 3) == 0)
            continue;
        direction = direction == nullptr ? weight : direction;
        const bool of_one = dot(weight, direction, 3) > 0;
        std::vector<double>& alone = of_one ? sides.one : sides.other;
        if (facts.features == clip::Features::points) // their mean has the swing of both sides
            alone[c + static_cast<std::size_t>(facts.up) - 1] = 1;
        else
            axpy(of_one ? 1 : -1, weight, &alone[c], 3);
        const Side named = names[c].side;
        if (named == Side::neither)
            continue;
        lefts += (named == Side::left) == of_one ? 1 : -1;
        axpy(1, &means[c], places[named == Side::left ? 0 : 1], 3);
        ++counts[named == Side::left ? 0 : 1];
    }
    if (lefts == 0 || counts[0] == 0 || counts[1] == 0)
        return sides;
    // Forward is left x up.
    const std::size_t first = static_cast<std::size_t>(facts.up) % 3, second = (first + 1) % 3;
    const auto left = [&](std::size_t axis) {
        return places[0][axis] / counts[0] - places[1][axis] / counts[1];
    };
    sides.forward = direction[first] * left(second) - direction[second] * left(first) > 0;
    sides.name = *sides.forward == (lefts > 0) ? Side::left : Side::right;
    return sides;
}

Source matrix_source(ConstMatrixView frames, double fps) {
    Source source;
    source.samples.count = frames.rows;
    source.samples.fps = fps;
    source.samples.feature_count = frames.cols;
    return source;
}

} // namespace stltsa::results
