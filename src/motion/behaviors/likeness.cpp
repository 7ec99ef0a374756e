// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/likeness.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/principal.hpp"
#include "linalg/simd.hpp"

namespace stltsa::motion {
namespace {

/// Covariances of moments that are 0 to 4 apart.
constexpr std::int64_t lags = 5;

/// Squared distance of shapes, which are shares of time, at which their likeness is 1/e. They are
/// one up to 0.03: otherwise a sine with a little noise would be divided.
constexpr double unlike_shapes = 0.07;

void normalize(std::vector<double>& values) {
    const auto count = static_cast<std::int64_t>(values.size());
    const double length = std::sqrt(dot(values.data(), values.data(), count));
    for (double& value : values)
        value = length > 0 ? value / length : 0;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
    return std::clamp(dot(a.data(), b.data(), static_cast<std::int64_t>(a.size())), 0.0, 1.0);
}

} // namespace

Describer::Describer(const KernelFeatures& features)
    : features_(features), velocities_(features.poses().rows(), features.poses().cols()) {
    const Matrix& poses = features.poses();
    for (std::int64_t i = 0; i + 1 < poses.rows(); ++i)
        for (std::int64_t c = 0; c < poses.cols(); ++c)
            velocities_(i, c) = poses(i + 1, c) - poses(i, c);
}

Description Describer::operator()(Rows moments) const {
    Description found;
    if (features_.of_shapes()) {
        found.shape = column_means(features_.poses().view().block(moments.begin, moments.count()));
        return found;
    }
    found.kernel.resize(static_cast<std::size_t>(features_.size()));
    features_.add_sum(moments, found.kernel.data());
    normalize(found.kernel);
    const std::int64_t p = velocities_.cols();
    found.moving.resize(lags * static_cast<std::size_t>(p * p));
    for (std::int64_t lag = 0; lag < lags; ++lag) {
        double* sums = found.moving.data() + lag * p * p;
        const std::int64_t count = moments.count() - lag;
        for (std::int64_t i = moments.begin; i < moments.begin + count; ++i)
            for (std::int64_t c = 0; c < p; ++c)
                axpy(velocities_(i, c) / static_cast<double>(count), velocities_.row(i + lag),
                     sums + c * p, p);
    }
    normalize(found.moving);
    return found;
}

double likeness(const Description& a, const Description& b) {
    if (!a.shape.empty())
        return std::exp(-squared_distance(a.shape.data(), b.shape.data(),
                                          static_cast<std::int64_t>(a.shape.size())) /
                        unlike_shapes);
    return std::sqrt(product(a.kernel, b.kernel) * product(a.moving, b.moving));
}

} // namespace stltsa::motion
