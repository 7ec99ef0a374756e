// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"
#include "linalg/machine.hpp"

namespace stltsa::ltsa {

namespace {

/// No branch for each number, because nearly all rows pass.
bool usable(const double* row, std::int64_t count) {
    std::int64_t within = 0;
    for (std::int64_t c = 0; c < count; ++c)
        within += std::abs(row[c]) <= largest_number; // false for NaN
    return within == count;
}

void check_row(const double* row, std::int64_t cols, std::int64_t r, const char* name) {
    for (std::int64_t c = 0; c < cols; ++c) {
        if (!std::isfinite(row[c]))
            fail(Status::not_finite, "{}: row {}, column {} is {}; fill or remove gaps first", name,
                 r, c, std::isnan(row[c]) ? "NaN" : "infinite");
        if (std::abs(row[c]) > largest_number)
            fail(Status::not_finite,
                 "{}: row {}, column {} is {}; beyond {} distances are infinite; use another unit",
                 name, r, c, row[c], largest_number);
    }
}

} // namespace

void check_numbers(ConstMatrixView numbers, const char* name, int threads) {
    for_row_blocks(numbers.rows, {Simd::baseline, threads},
                   [&](std::int64_t, std::int64_t first, std::int64_t rows) {
                       for (std::int64_t r = first; r < first + rows; ++r)
                           if (!usable(numbers.row(r), numbers.cols))
                               check_row(numbers.row(r), numbers.cols, r, name);
                   });
}

void check_frames(ConstMatrixView frames, std::span<const std::int64_t> lengths, const char* name,
                  int threads) {
    if (frames.rows < 1 || frames.cols < 1)
        fail(Status::shape, "{} frames of {} features were given; at least one of each is needed",
             frames.rows, frames.cols);
    if (frames.rows > std::numeric_limits<std::int32_t>::max())
        fail(Status::unsupported, "{} frames are too many; the limit is {}", frames.rows,
             std::numeric_limits<std::int32_t>::max());
    std::int64_t left = frames.rows;
    for (std::size_t c = 0; c < lengths.size(); ++c) {
        if (lengths[c] < 1 || lengths[c] > left)
            fail(Status::shape,
                 "clip {} has length {}, with {} frames left of {}; lengths must be "
                 "positive and sum to the number of frames",
                 c, lengths[c], left, frames.rows);
        left -= lengths[c];
    }
    if (left != 0)
        fail(Status::shape, "the clips' lengths sum to {}, not to the {} frames given",
             frames.rows - left, frames.rows);
    check_numbers(frames, name, threads);
}

namespace {

/// For each frame, 1 if it equals the previous one, else 0.
std::vector<std::uint8_t> repeats(ConstMatrixView frames, int threads) {
    std::vector<std::uint8_t> result(static_cast<std::size_t>(frames.rows));
    for_row_blocks(
        frames.rows, {Simd::baseline, threads},
        [&](std::int64_t, std::int64_t first, std::int64_t rows) {
            for (std::int64_t i = std::max<std::int64_t>(first, 1); i < first + rows; ++i)
                if (std::equal(frames.row(i), frames.row(i) + frames.cols, frames.row(i - 1)))
                    result[static_cast<std::size_t>(i)] = 1;
        });
    return result;
}

} // namespace

DistinctFrames collapse_repeats(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                                int threads) {
    const std::vector<std::uint8_t> repeated = repeats(frames, threads);
    DistinctFrames distinct;
    distinct.row_of.resize(static_cast<std::size_t>(frames.rows));
    std::int32_t kept = 0;
    std::int64_t first = 0;
    for (const std::int64_t length : lengths) {
        const std::int32_t before = kept;
        for (std::int64_t i = first; i < first + length; ++i) {
            if (i == first || repeated[static_cast<std::size_t>(i)] == 0)
                ++kept;
            distinct.row_of[static_cast<std::size_t>(i)] = kept - 1;
        }
        distinct.lengths.push_back(kept - before);
        first += length;
    }
    distinct.repeated = frames.rows - kept;
    distinct.x = frames;
    if (distinct.repeated > 0) {
        distinct.storage = Matrix(kept, frames.cols);
        for (std::int64_t i = frames.rows; i-- > 0;) // of equal frames, the first is copied last
            std::copy_n(frames.row(i), frames.cols,
                        distinct.storage.row(distinct.row_of[static_cast<std::size_t>(i)]));
        distinct.x = distinct.storage.view();
    }
    return distinct;
}

void fail_changed(std::int64_t frame) {
    fail(Status::not_finite,
         "distances to frame {} became NaN during the call, so the frames were changed; do not "
         "write to an array while a call reads it",
         frame);
}

namespace {

/// Frames farther apart than this are not scaled. The limit has a wide margin, because distances
/// within a window are smaller, columns differ in size, and fourth powers occur: fits were accurate
/// down to 1e-70 with columns of sizes 1e-11 to 1.
constexpr double tiny_spread = 0x1p-100;

/// The largest difference of an entry from the first frame's; any value if above tiny_spread.
double spread_of(ConstMatrixView x) {
    double spread = 0;
    for (std::int64_t i = 1; i < x.rows && spread <= tiny_spread; ++i)
        for (std::int64_t c = 0; c < x.cols; ++c)
            spread = std::max(spread, std::abs(x(i, c) - x(0, c)));
    return spread;
}

} // namespace

int power_if_tiny(ConstMatrixView x) {
    const double spread = spread_of(x);
    return spread > 0 && spread <= tiny_spread ? -std::ilogb(spread) : 0;
}

Matrix scaled(ConstMatrixView x, int power) {
    Matrix result = Matrix::unset(x.rows, x.cols);
    for (std::int64_t i = 0; i < x.rows; ++i)
        std::transform(x.row(i), x.row(i) + x.cols, result.row(i),
                       [power](double value) { return std::scalbn(value, power); });
    return result;
}

void scale_tiny(DistinctFrames& frames) {
    const int power = power_if_tiny(frames.x);
    if (power == 0)
        return;
    frames.storage = scaled(frames.x, power);
    frames.x = frames.storage.view();
}

namespace {

void check_clip_lengths(const Parameters& parameters, const DistinctFrames& frames,
                        std::int64_t needed) {
    const bool one = frames.lengths.size() == 1;
    for (std::size_t c = 0; c < frames.lengths.size(); ++c)
        if (frames.lengths[c] < needed)
            fail(Status::too_few_frames,
                 "{} has {} distinct frames, but {} neighbors need at least "
                 "{}; use fewer neighbors{}",
                 one ? "the clip" : format_text("clip {}", c), frames.lengths[c],
                 parameters.neighbors, needed, one ? "" : " or omit this clip");
}

/// Throws if each clip has one distinct frame but several were given.
void check_variation(const DistinctFrames& frames) {
    if (frames.repeated > 0 && frames.x.rows == static_cast<std::int64_t>(frames.lengths.size()))
        fail(Status::degenerate, "nothing moves: {}",
             frames.lengths.size() == 1 ? "all frames are the same"
                                        : "the frames of each clip are the same");
}

} // namespace

void check_parameters(const Parameters& p, const DistinctFrames& frames) {
    if (p.dimension < 1)
        fail(Status::argument, "dimension is {}; at least 1 is needed", p.dimension);
    if (p.neighbors < p.dimension + 2)
        fail(Status::argument,
             "{} neighbors cannot span {} dimensions: at least dimension + 2 = {} "
             "are needed",
             p.neighbors, p.dimension, p.dimension + 2);
    const std::int64_t self = p.include_self ? 1 : 0;
    if (p.mode == Mode::spatial) {
        check_variation(frames);
        if (frames.x.rows < p.neighbors + 1)
            fail(Status::too_few_frames,
                 "{} distinct frames are too few for {} neighbors: at "
                 "least {} are needed",
                 frames.x.rows, p.neighbors, p.neighbors + 1);
        return;
    }
    if (p.neighbors > p.window + self)
        fail(Status::argument,
             "{} neighbors do not fit into the window of {} frames on each side, "
             "which leaves {} at the ends of a clip; use a window of at least {}",
             p.neighbors, p.window, p.window + self, p.neighbors - self);
    check_variation(frames);
    check_clip_lengths(p, frames, p.neighbors + 1);
    if (p.mode == Mode::recurrent && p.links < 1)
        fail(Status::argument, "recurrent neighbors with {} links; at least 1 is needed", p.links);
    if (p.mode == Mode::recurrent && p.exclusion < p.window)
        fail(Status::argument,
             "the exclusion zone of +-{} frames is smaller than the window of +-{} "
             "that the temporal neighbors come from",
             p.exclusion, p.window);
}

} // namespace stltsa::ltsa
