// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/difference_terms.hpp"

#include <algorithm>

#include "ltsa/column_blocks.hpp"

namespace stltsa::ltsa {

namespace {

/// The sum of value(j) over the neighbors beyond each difference; from the last one to the first,
/// over those before it.
template <class Value>
void spread_sums(std::span<const std::int32_t> frames, Order order, const Value& value,
                 double* to) {
    double sum = 0;
    if (order == Order::of_time)
        for (std::size_t j = frames.size(); j-- > 1;) {
            sum += value(j);
            for (auto c = frames[j]; c-- > frames[j - 1];)
                to[c - frames.front()] = sum;
        }
    else
        for (std::size_t j = 0; j + 1 < frames.size(); ++j) {
            sum += value(j);
            for (auto c = frames[j]; c < frames[j + 1]; ++c)
                to[frames.back() - 1 - c] = sum;
        }
}

} // namespace

void spread_counts(const Patches& patches, std::int64_t patch, Order order, double* to) {
    spread_sums(
        patches.of(patch), order, [](std::size_t) { return 1.0; }, to);
}

void spread_directions(const Patches& patches, std::int64_t patch, Order order, double* to,
                       std::int64_t stride) {
    for (std::int64_t l = 0; l < patches.dimension(); ++l) {
        const double* g = patches.direction(patch, l);
        spread_sums(
            patches.of(patch), order, [g](std::size_t j) { return g[j]; }, to + l * stride);
    }
}

Envelope envelope_of(const Patches& patches, const Machine& machine) {
    constexpr std::int64_t block = 4096;
    Envelope reach(static_cast<std::size_t>(patches.frames() - 1));
    const auto reach_at = [&](std::int64_t c) -> auto& {
        return reach[static_cast<std::size_t>(c)];
    };
    const auto order = static_cast<std::int64_t>(reach.size());
    for_column_blocks(patches, order, block, machine.threads,
                      [&](std::int64_t begin, std::int64_t end, PatchRange range) {
                          for (std::int64_t c = begin; c < end; ++c)
                              reach_at(c) = c;
                          for (std::int64_t p = range.begin; p < range.end; ++p) {
                              const auto frames = patches.of(p);
                              const std::int64_t c = frames.front();
                              if (begin <= c && c < end)
                                  reach_at(c) =
                                      std::max<std::int64_t>(reach_at(c), frames.back() - 1);
                          }
                          for (std::int64_t c = begin + 1; c < end; ++c)
                              reach_at(c) = std::max(reach_at(c), reach_at(c - 1));
                      });
    for (std::int64_t begin = block; begin < order; begin += block)
        for (std::int64_t c = begin; c < order && reach_at(c) < reach_at(c - 1); ++c)
            reach_at(c) = reach_at(c - 1);
    return reach;
}

} // namespace stltsa::ltsa
