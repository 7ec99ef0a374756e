// SPDX-License-Identifier: BSD-3-Clause
// The phase of a stream, frame by frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "phase/live_cycle.hpp"
#include "phase/live_filter.hpp"

namespace stltsa::phase {

/// What a frame of a stream is.
struct LiveFrame {
    double phase = 0; ///< in [0, 1)
    double turns_per_second = 0;
    double turns = 0;        ///< since the first frame; also parts of a turn
    double distance = 0;     ///< from the mean cycle: 1 is the limit; NaN if the frame is missing
    double confidence = 0;   ///< 0 to 1: how sharply the phase is known
    bool known = true;       ///< whether this is the motion of the cycle
    bool still = false;      ///< the body does not move
    std::int64_t passed = 0; ///< bit i: mark i was passed since the frame before
};

inline constexpr std::size_t most_marks = 62;

/// Follows one stream. Allocates when it is made, and never again.
class LivePhase {
  public:
    /// `marks`: phases, at most most_marks; they are reported as they pass.
    LivePhase(const LiveCycle& cycle, std::span<const double> marks);

    /// `seconds` rises from frame to frame. A frame that comes with the time of the one before, or
    /// up to a quarter of a second earlier, is left out: clocks are coarse, and packets overtake
    /// each other. If time falls by more, or after a gap of more than a second, the filter starts
    /// anew. Features that are not finite, or too far away for any body, are missing.
    LiveFrame push(double seconds, const double* features);
    /// A frame of which nothing is known: the phase goes on as before, less and less surely.
    LiveFrame go_on(double seconds);

  private:
    bool possible(const double* features) const;
    void start();
    void filter(double seconds, const double* features);
    void project();
    double nearest_place();
    void predict(double seconds, bool is_far);
    void rest(double seconds);
    void settle();
    void correct();
    LiveFrame estimate();
    LiveFrame answer(double seconds, double distance);
    void notice_rest(double seconds);
    std::int64_t passed();

    LiveCycle cycle_;
    LiveFilter filter_;
    std::vector<double> both_, coordinates_, whitened_;
    Matrix whitened_places_, whitened_rests_;
    std::vector<double> squared_, squared_rest_; ///< distance of the frame from each place
    Matrix likely_;                              ///< rates x places; the last row rests
    std::vector<double> moved_;                  ///< a row of likely_ after a step
    Matrix blurred_;                             ///< all rows but the last, moved and blurred
    std::vector<double> rates_, prior_, blur_;
    Matrix circle_;      ///< cosine and sine of each place
    double outside_ = 0; ///< squared distance from the principal directions
    std::vector<double> marks_;
    double reached_ = 0;  ///< unwrapped phase up to which marks were reported
    double age_s_ = 0;    ///< since the filter started
    double rested_s_ = 0; ///< since the body is still
    double last_ = 0;     ///< time of the last frame that was not missing
    double now_ = 0;      ///< time up to which the phase was moved on
    double last_phase_ = 0, unwrapped_ = 0, turns_ = 0, unknown_s_ = 0;
    bool begun_ = false, known_ = true, still_ = false;
    LiveFrame latest_;
};

} // namespace stltsa::phase
