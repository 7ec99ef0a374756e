// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangent_track.hpp"

#include <algorithm>

#include "linalg/simd.hpp"
#include "ltsa/local_pca.hpp"

namespace stltsa::ltsa {
namespace {

/// Frames of a sequence. Rounding must not add up for long, nor may the motion go far from where
/// the origin lies: half a window is as far as its own frames are.
constexpr std::int64_t shortest_sequence = 4;
constexpr std::int64_t longest_sequence = 64;

/// Where a covariance matrix has shrunk to less than this share of itself, as when a jump leaves
/// the window, the rounding of what it was counts: a new sequence begins.
constexpr double least_share = 1.0 / 16;

/// What the frames of a neighborhood, about an origin, have in each direction of the features: the
/// tangents but for their mean and size.
struct ProjectFrames {
    ConstMatrixView x;
    std::span<const std::int32_t> members;
    const double* origin;
    ConstMatrixView vectors; ///< a direction in each row
    double* out;             ///< of each direction as many entries as there are members

    template <int W>
    STLTSA_INLINE void run() const {
        std::int64_t l = 0;
        for (; l + 2 <= vectors.rows; l += 2)
            project<W, 2>(l);
        for (; l < vectors.rows; ++l)
            project<W, 1>(l);
    }

    /// For `count` directions from l on, which share what a frame takes to load.
    template <int W, std::int64_t count>
    STLTSA_INLINE void project(std::int64_t l) const {
        const auto size = static_cast<std::int64_t>(members.size());
        std::int64_t a = 0;
        for (; a + 2 <= size; a += 2)
            multiply<W, count, 2>(a, l);
        for (; a < size; ++a)
            multiply<W, count, 1>(a, l);
    }

    template <int W, std::int64_t count, std::int64_t frames>
    STLTSA_INLINE void multiply(std::int64_t a, std::int64_t l) const {
        const double* frame[frames];
        for (std::int64_t f = 0; f < frames; ++f)
            frame[f] = x.row(members[static_cast<std::size_t>(a + f)]);
        Pack<W> sums[frames][count][lanes / W] = {};
        std::int64_t i = 0;
        for (; i + lanes <= x.cols; i += lanes)
            for (std::int64_t part = 0; part < lanes / W; ++part) {
                const std::int64_t at = i + part * W;
                for (std::int64_t f = 0; f < frames; ++f) {
                    const Pack<W> d = load<Pack<W>>(frame[f] + at) - load<Pack<W>>(origin + at);
                    for (std::int64_t j = 0; j < count; ++j)
                        sums[f][j][part] += d * load<Pack<W>>(vectors.row(l + j) + at);
                }
            }
        for (std::int64_t f = 0; f < frames; ++f)
            for (std::int64_t j = 0; j < count; ++j) {
                double s[lanes];
                for (std::int64_t lane = 0; lane < lanes; ++lane)
                    s[lane] = sums[f][j][lane / W][lane % W];
                for (std::int64_t c = i; c < x.cols; ++c)
                    s[c - i] += (frame[f][c] - origin[c]) * vectors(l + j, c);
                out[(l + j) * static_cast<std::int64_t>(members.size()) + a + f] = sum_lanes(s);
            }
    }
};

} // namespace

TangentTrack::TangentTrack(ConstMatrixView x, const Neighborhoods& neighborhoods,
                           std::int64_t count, Simd simd, Matrix& values, Tangents& tangents)
    : x_(x), neighborhoods_(neighborhoods), count_(count), simd_(simd), values_(values),
      tangents_(tangents), batch_(x.cols, neighborhoods.size, count, simd),
      origins_(batch_.lanes(), x.cols), vectors_(count, x.cols),
      largest_trace_(static_cast<std::size_t>(batch_.lanes())),
      begins_(static_cast<std::size_t>(batch_.lanes())) {}

std::vector<std::int64_t> TangentTrack::find(std::int64_t first, std::int64_t last) {
    std::vector<std::int64_t> missing;
    const std::int64_t length =
        std::clamp<std::int64_t>(neighborhoods_.size / 2, shortest_sequence, longest_sequence);
    for (std::int64_t begin = first; begin < last; begin += batch_.lanes() * length)
        follow(begin, std::min(begin + batch_.lanes() * length, last), length, missing);
    std::sort(missing.begin(), missing.end());
    return missing;
}

/// A sequence of `length` frames in each lane; the last ones may be shorter, or empty.
void TangentTrack::follow(std::int64_t begin, std::int64_t end, std::int64_t length,
                          std::vector<std::int64_t>& missing) {
    batch_.clear();
    std::fill(begins_.begin(), begins_.end(), std::uint8_t{1});
    for (std::int64_t step = 0; step < length; ++step) {
        for (std::int64_t lane = 0; lane < batch_.lanes(); ++lane) {
            const std::int64_t frame = begin + lane * length + step;
            if (frame >= end)
                break;
            if (begins_[static_cast<std::size_t>(lane)])
                begin_sequence(lane, frame);
            else
                move_on(lane, frame);
        }
        batch_.solve();
        for (std::int64_t lane = 0; lane < batch_.lanes(); ++lane) {
            const std::int64_t frame = begin + lane * length + step;
            if (frame >= end)
                break;
            if (!lost_digits(lane) && batch_.found(lane))
                write(lane, frame);
            else
                missing.push_back(frame);
        }
    }
}

void TangentTrack::begin_sequence(std::int64_t lane, std::int64_t frame) {
    const auto members = neighborhoods_.of(frame);
    double* origin = origins_.row(lane);
    // About a member first: a large common offset would leave the mean few digits.
    const double* middle = x_.row(members[members.size() / 2]);
    std::fill_n(origin, x_.cols, 0.0);
    for (const std::int32_t member : members)
        for (std::int64_t c = 0; c < x_.cols; ++c)
            origin[c] += x_(member, c) - middle[c];
    for (std::int64_t c = 0; c < x_.cols; ++c)
        origin[c] = middle[c] + origin[c] / static_cast<double>(members.size());
    batch_.restart(lane, origin);
    largest_trace_[static_cast<std::size_t>(lane)] = 0;
    begins_[static_cast<std::size_t>(lane)] = 0;
    for (const std::int32_t member : members)
        batch_.change(lane, x_.row(member), 1);
}

bool TangentTrack::lost_digits(std::int64_t lane) {
    const auto l = static_cast<std::size_t>(lane);
    const double trace = batch_.trace(lane);
    largest_trace_[l] = std::max(largest_trace_[l], trace);
    const bool lost = trace < least_share * largest_trace_[l];
    begins_[l] = lost ? 1 : 0;
    return lost;
}

void TangentTrack::move_on(std::int64_t lane, std::int64_t frame) {
    const auto before = neighborhoods_.of(frame - 1);
    const auto after = neighborhoods_.of(frame);
    auto a = before.begin();
    auto b = after.begin();
    while (a != before.end() || b != after.end())
        if (b == after.end() || (a != before.end() && *a < *b)) {
            batch_.change(lane, x_.row(*a++), -1);
        } else if (a == before.end() || *b < *a) {
            batch_.change(lane, x_.row(*b++), 1);
        } else {
            ++a;
            ++b;
        }
}

void TangentTrack::write(std::int64_t lane, std::int64_t frame) {
    for (std::int64_t l = 0; l < count_; ++l) {
        values_(frame, l) = batch_.value(lane, l);
        for (std::int64_t c = 0; c < x_.cols; ++c)
            vectors_(l, c) = batch_.vector(lane, l, c);
    }
    double* g = tangents_.direction(frame, 0);
    run_simd(simd_,
             ProjectFrames{x_, neighborhoods_.of(frame), origins_.row(lane), vectors_.view(), g});
    for (std::int64_t l = 0; l < count_; ++l)
        make_tangent(g, l, neighborhoods_.size, g + l * neighborhoods_.size);
}

} // namespace stltsa::ltsa
