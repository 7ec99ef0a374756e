// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/local_svd.hpp"

#include <algorithm>

#include "linalg/simd.hpp"
#include "ltsa/local_pca.hpp"

namespace stltsa::ltsa {

bool LocalSvd::compute(std::span<const std::int32_t> neighborhood) {
    // Centered about the middle frame first, so that a large common offset costs no digits.
    const double* origin = x_.row(neighborhood[neighborhood.size() / 2]);
    for (std::int64_t c = 0; c < x_.cols; ++c) {
        double* column = svd_.matrix() + c * size_;
        for (std::int64_t a = 0; a < size_; ++a)
            column[a] = x_(neighborhood[static_cast<std::size_t>(a)], c) - origin[c];
        const double mean = sum(column, size_) / static_cast<double>(size_);
        for (std::int64_t a = 0; a < size_; ++a)
            column[a] -= mean;
    }
    return svd_.solve();
}

void LocalSvd::direction(std::int64_t l, double* out, const double* before) const {
    std::copy_n(svd_.vector(l), size_, out);
    make_tangent(before, l, size_, out);
}

} // namespace stltsa::ltsa
