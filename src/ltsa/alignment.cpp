// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/alignment.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace stltsa::ltsa {

void center(std::span<double> x) {
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
    for (double& value : x)
        value -= mean;
}

void Alignment::apply(std::span<const double> in, std::span<double> out) const {
    std::vector<double> values(static_cast<std::size_t>(patches_->size()));
    std::fill(out.begin(), out.end(), 0.0);
    for (std::int64_t p = 0; p < patches_->count(); ++p) {
        gather(p, in, values.data());
        patches_->project(p, values.data());
        scatter(p, values.data(), out);
    }
}

} // namespace stltsa::ltsa
