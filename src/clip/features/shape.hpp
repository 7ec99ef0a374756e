// SPDX-License-Identifier: BSD-3-Clause
// Points of one frame relative to the body, without the frames around it.
#pragma once

#include <span>
#include <vector>

#include "clip/body/up_axis.hpp"
#include "clip/features/gaps.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// What is removed from the points of a frame.
struct ShapeRule {
    int width = 1;        ///< columns of a group: 2 or 3 of a point, 1 of a bare matrix
    bool travels = false; ///< the mean of the points
    bool turns = false;   ///< the heading: the turn that brings them closest to the mean shape
    Axis up = Axis::none; ///< of points in space that turn
};

/// The shapes that a body has, as learned from a clip: their mean, and how they vary about it.
struct Shape {
    ShapeRule rule;
    std::vector<double> used;      ///< of each group, 1; 0: it is left out, and its columns are 0
    std::vector<double> mean;      ///< of the columns
    Matrix directions;             ///< principal directions, a row each
    std::vector<double> variances; ///< along them
    double rest = 0;               ///< variance of each column across them
};

/// `rows`: features of the clip, finite. Groups that are 0 throughout, and those of the columns
/// `drifting`, are left out. `chosen`: the frames that count.
/// Status::degenerate if no group is left.
Shape learn_shape(ConstMatrixView rows, std::span<const Frames> chosen, const ShapeRule& rule,
                  std::span<const std::int64_t> drifting);

/// Frame by frame. Allocates only when it is made.
class ShapeFeatures {
  public:
    explicit ShapeFeatures(Shape shape);

    std::int64_t count() const { return static_cast<std::int64_t>(shape_.mean.size()); }
    /// `values`: as in the clip, missing ones as in Gaps. These become what the others imply: the
    /// conditional mean under the shapes of the clip. False if more than half of the groups are
    /// missing: then nothing is known of the body.
    bool next(const double* values, double* features);

  private:
    struct Flat {
        double a = 0, b = 0;
    };

    bool find_seen(const double* values);
    void move(double* features, const std::vector<char>& of);
    void turn(double* features, const std::vector<char>& of);
    template <class Body>
    void for_missing(const Body& body) const;
    void prepare_fill();
    void fill(double* features);

    Shape shape_;
    std::int64_t groups_;
    int first_ = 0, second_ = 1; ///< the horizontal axes
    double least_match_ = 0;     ///< shorter matches have no heading
    Flat turn_{1, 0};            ///< of the last frame that had a heading
    std::vector<char> all_, seen_;
    std::vector<double> matrix_, weights_, off_; ///< of the conditional mean
};

} // namespace stltsa::clip
