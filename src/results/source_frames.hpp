// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "results/facts.hpp"

namespace stltsa::results {

/// Maps positions among the working samples to the source file.
class SourceFrames {
  public:
    SourceFrames(const Source& source, const std::vector<clip::Frames>& holes)
        : samples_(source.samples), clip_(source.clips.front()), recorded_{0, clip_.frames} {
        if (!holes.empty() && holes.front().begin == 0)
            recorded_.begin = holes.front().end;
        if (!holes.empty() && holes.back().end == clip_.frames)
            recorded_.end = holes.back().begin;
    }

    /// Without the frames before the body comes and after it has left.
    const clip::Frames& recorded() const { return recorded_; }

    template <class To>
    void set(double begin, double end, To& to) const {
        const double first = frame(begin), last = frame(end);
        to.begin = std::llround(first);
        to.end = std::llround(last);
        to.begin_s = first / clip_.fps;
        to.end_s = last / clip_.fps;
    }

    /// Extends the first one to the first frame recorded and the last one to the last: a T-pose
    /// belongs to the first, frames after the last sample to the last.
    template <class To>
    void cover_recorded(std::vector<To>& intervals) const {
        if (intervals.empty())
            return;
        intervals.front().begin = recorded_.begin;
        intervals.front().begin_s = static_cast<double>(recorded_.begin) / clip_.fps;
        intervals.back().end = recorded_.end;
        intervals.back().end_s = static_cast<double>(recorded_.end) / clip_.fps;
    }

    template <class To>
    To interval(const clip::Frames& frames) const {
        To made{};
        made.begin = frames.begin;
        made.end = frames.end;
        made.begin_s = static_cast<double>(frames.begin) / clip_.fps;
        made.end_s = static_cast<double>(frames.end) / clip_.fps;
        return made;
    }

    double sample(double frame) const {
        return (frame - static_cast<double>(samples_.first)) / static_cast<double>(samples_.step);
    }

    double seconds(double samples) const {
        return samples * static_cast<double>(samples_.step) / clip_.fps;
    }

  private:
    /// Several frames may follow the last sample, or none.
    double frame(double sample) const {
        return std::min(static_cast<double>(recorded_.end),
                        static_cast<double>(samples_.first) +
                            sample * static_cast<double>(samples_.step));
    }

    const SampleFacts& samples_;
    const ClipFacts& clip_;
    clip::Frames recorded_;
};

} // namespace stltsa::results
