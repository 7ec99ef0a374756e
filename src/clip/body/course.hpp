// SPDX-License-Identifier: BSD-3-Clause
// Where the body goes over the ground, and how it turns.
#pragma once

#include "clip/body/up_axis.hpp"

namespace stltsa::clip {

/// Between two moments; NaN: unknown.
struct Travel {
    double way;    ///< length of the path over the ground, file units
    double stride; ///< distance between its ends
    double turn;   ///< degrees, counterclockwise as seen from above
};

/// The path of the body root of a skeleton, or of the mean of points; the heading of the body root,
/// or the turn of the points about the up axis.
class Course {
  public:
    /// `point_columns`: columns of each point, 2 or 3, of a clip of points; 0: of another clip.
    /// Without a skeleton, points or an up axis everything is unknown.
    Course(const Clip& clip, Axis up, int point_columns);

    /// From one frame to another, both fractional and within the clip. The turn of points compares
    /// the postures at both ends, which should be alike.
    Travel between(double begin, double end) const;

  private:
    struct Plane {
        std::int64_t first = 0, second = 1; ///< axes; the up axis is their cross product
        int columns = 0;                    ///< of each point; 0: a skeleton
    };
    struct Motion {
        double along = 0, across = 0, turn = 0; ///< file units, radians
        std::int64_t points = 0;                ///< seen in both frames
    };

    void follow_root(const Clip& clip, Axis up);
    void follow_points(const Clip& clip);
    Motion motion_of_points(std::int64_t from, std::int64_t to) const;
    void advance(std::int64_t frame, const Motion& motion);
    double at(double frame, std::int64_t column) const;
    double turn_between(double begin, double end) const;

    Plane plane_;
    Matrix points_; ///< of a clip of points: its values
    Matrix course_; ///< frames x {along, across, way, turn in radians}; empty: unknown
};

} // namespace stltsa::clip
