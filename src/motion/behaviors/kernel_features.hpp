// SPDX-License-Identifier: BSD-3-Clause
// What the body does around each moment, as vectors whose products are a Gaussian kernel (Nystroem
// features: Williams, Seeger, NIPS 2000) of the windowed means and deviations of poses and
// velocities, or of shapes if there are few columns. Sums over time are kept, so that a range costs
// the same whatever its length.
#pragma once

#include <vector>

#include "motion/period/signal.hpp"

namespace stltsa::motion {

class KernelFeatures {
  public:
    /// `beside`: see even_poses().
    explicit KernelFeatures(const Signal& signal, const Matrix& beside = {});

    /// moments x directions, see even_poses(), or make_shapes() if shapes are described.
    const Matrix& poses() const { return poses_; }
    /// Whether the shapes of few columns are described (make_shapes()).
    bool of_shapes() const { return of_shapes_; }

    /// Number of moments; moment i is row i * step() of the signal.
    std::int64_t count() const { return sums_.rows() - 1; }
    std::int64_t step() const { return step_; }

    /// The moments of rows of the signal, at least one.
    Rows moments(Rows rows) const;

    std::int64_t size() const { return sums_.cols(); } ///< features of a moment
    /// Adds the sum of the features over the moments to `sum`, size() values.
    void add_sum(Rows moments, double* sum) const;

    /// Sum of squared distances from the mean of moments [begin, end).
    double cost(std::int64_t begin, std::int64_t end) const;
    /// How much two ranges cost less than the whole.
    double gain(std::int64_t begin, std::int64_t middle, std::int64_t end) const;
    /// The same of two ranges that need not touch.
    double gain(Rows a, Rows b) const;

  private:
    Matrix poses_;
    bool of_shapes_ = false;
    std::int64_t step_ = 1;
    Matrix sums_;                 ///< (moments + 1) x features
    std::vector<double> squares_; ///< running sum of squared lengths
};

} // namespace stltsa::motion
