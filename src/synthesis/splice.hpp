// SPDX-License-Identifier: BSD-3-Clause
// Puts the channels of the new clip together, frame by frame.
#pragma once

#include <cstdint>

#include "synthesis/cuts.hpp"

namespace stltsa::synthesis {

/// How much of the later stretch is in frame i of a crossfade, -crossfade <= i < crossfade.
double crossfade_weight(std::int64_t i, std::int64_t crossfade);

/// Outside of crossfades each stretch is its source moved by one rigid motion in the plane, or
/// turned a little more in each frame: nothing but the root's channels differs from the source, and
/// before the first seam not even they do.
class Splicer {
  public:
    /// `frames`: of the new clip.
    Splicer(const Body& body, std::int64_t frames);

    /// Frames [begin, end) of the track that is being played. `turn`: radians more in each frame,
    /// after a seam only.
    void play(const Track& track, std::int64_t begin, std::int64_t end, double turn = 0);
    /// The crossfade from one track into another: 2 * cut.crossfade frames. What is played next
    /// goes on from where it leads.
    void cross(const Track& earlier, const Track& later, const Cut& cut, double turn = 0);

    Matrix take() { return std::move(values_); }

  private:
    /// A frame between frame a of one track and frame b of another.
    struct Mixture {
        const Track& earlier;
        std::int64_t a;
        const Track& later;
        std::int64_t b;
        double weight; ///< of the later one
    };

    double* new_row();
    void blend(const Mixture& mixture, double weight_gained, double turn);

    const Body& body_;
    Matrix values_;
    std::int64_t next_ = 0;
    bool in_place_ = true; ///< nothing was moved yet
    Placement placement_;
    RootState last_; ///< of the last frame that was written
};

} // namespace stltsa::synthesis
