// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/difference_terms.hpp"

#include <algorithm>
#include <numeric>

namespace stltsa::ltsa {

namespace {

/// The sum of value(j) over the neighbors beyond each difference.
template <class Value>
void spread_sums(std::span<const std::int32_t> frames, const Value& value, double* to) {
    double sum = 0;
    for (std::size_t j = frames.size(); j-- > 1;) {
        sum += value(j);
        for (auto c = frames[j]; c-- > frames[j - 1];)
            to[c - frames.front()] = sum;
    }
}

} // namespace

void spread_counts(const Patches& patches, std::int64_t patch, double* to) {
    spread_sums(
        patches.of(patch), [](std::size_t) { return 1.0; }, to);
}

void spread_directions(const Patches& patches, std::int64_t patch, double* to,
                       std::int64_t stride) {
    for (std::int64_t l = 0; l < patches.dimension(); ++l) {
        const double* g = patches.direction(patch, l);
        spread_sums(
            patches.of(patch), [g](std::size_t j) { return g[j]; }, to + l * stride);
    }
}

Envelope envelope_of(const Patches& patches) {
    Envelope reach(static_cast<std::size_t>(patches.frames() - 1));
    std::iota(reach.begin(), reach.end(), 0);
    for (std::int64_t p = 0; p < patches.count(); ++p) {
        const auto frames = patches.of(p);
        if (frames.front() == frames.back())
            continue;
        std::int64_t& column = reach[static_cast<std::size_t>(frames.front())];
        column = std::max<std::int64_t>(column, frames.back() - 1);
    }
    for (std::size_t c = 1; c < reach.size(); ++c)
        reach[c] = std::max(reach[c], reach[c - 1]);
    return reach;
}

} // namespace stltsa::ltsa
