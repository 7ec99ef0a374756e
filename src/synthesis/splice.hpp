// SPDX-License-Identifier: BSD-3-Clause
// Assembles the channels of the new clip, frame by frame.
#pragma once

#include <cstdint>

#include "synthesis/cuts.hpp"

namespace stltsa::synthesis {

/// Weight of the later run in frame i of a crossfade, -crossfade <= i < crossfade.
double crossfade_weight(std::int64_t i, std::int64_t crossfade);

/// Outside crossfades each run is its source after one rigid motion in the plane, possibly with a
/// small extra turn in each frame: only the root's channels differ from the source, and before the
/// first seam none do.
class Splicer {
  public:
    /// `frames`: length of the new clip.
    Splicer(const Body& body, std::int64_t frames);

    /// Plays frames [begin, end) of the current track. `turn`: extra radians per frame, after a
    /// seam only.
    void play(const Track& track, std::int64_t begin, std::int64_t end, double turn = 0);
    /// Plays the crossfade from one track into another: 2 * cut.crossfade frames. The next call
    /// continues from its end.
    void cross(const Track& earlier, const Track& later, const Cut& cut, double turn = 0);

    /// The crossfade across the wrap of a loop. First call: its half after the cut, at the place of
    /// the later track.
    void enter_loop(const Track& earlier, const Track& later, const Cut& cut, double turn = 0);
    /// Last call: its half before the cut. Returns the motion of one loop: the state in the frame
    /// that would follow is that of the first frame after this step.
    Step close_loop(const Track& earlier, const Track& later, const Cut& cut, double turn = 0);

    Matrix take() { return std::move(values_); }

  private:
    /// Interpolates between frame a of one track and frame b of another.
    struct Mixture {
        const Track& earlier;
        std::int64_t a;
        const Track& later;
        std::int64_t b;
        double weight; ///< of b
    };

    double* new_row();
    RootState blended(const Mixture& mixture, double weight_gained, double turn) const;
    void blend(const Mixture& mixture, double weight_gained, double turn);
    /// Frames [from, to) of a crossfade, relative to its cut.
    void blend_all(const Track& earlier, const Track& later, const Cut& cut, std::int64_t from,
                   std::int64_t to, double turn);
    RootState unblended(const Track& earlier, const Track& later, const Cut& cut) const;

    const Body& body_;
    Matrix values_;
    std::int64_t next_ = 0;
    bool in_place_ = true; ///< no run has been moved yet
    Placement placement_;
    RootState last_;  ///< state in the last written frame
    RootState first_; ///< state in frame 0
};

} // namespace stltsa::synthesis
