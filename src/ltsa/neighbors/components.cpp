// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/neighbors/components.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace stltsa::ltsa {
namespace {

/// Union-find with path halving. The root of a set is its smallest frame, and no parent is a later
/// frame.
class DisjointSets {
  public:
    explicit DisjointSets(std::int64_t count) : parent_(static_cast<std::size_t>(count)) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    /// The parent of each frame; ends the use of the sets.
    UnsetVector<std::int32_t> release() { return std::move(parent_); }
    std::int32_t find(std::int32_t frame) {
        while (parent(frame) != frame) {
            parent(frame) = parent(parent(frame));
            frame = parent(frame);
        }
        return frame;
    }
    /// Unites the set of a frame with that of a root; returns the root of both.
    std::int32_t unite(std::int32_t root, std::int32_t frame) {
        if (parent(frame) == root) // the usual case
            return root;
        const std::int32_t other = find(frame);
        parent(std::max(root, other)) = std::min(root, other);
        return std::min(root, other);
    }

  private:
    std::int32_t& parent(std::int32_t frame) { return parent_[static_cast<std::size_t>(frame)]; }
    UnsetVector<std::int32_t> parent_;
};

/// Whether the neighborhood of each frame but the first contains the frame and an earlier one. Then
/// all frames are connected, which is the usual case for temporal neighborhoods of one clip.
bool each_frame_joins_an_earlier_one(const Neighborhoods& neighborhoods, const Machine& machine) {
    const std::int64_t n = neighborhoods.frames();
    std::vector<char> block_joins(static_cast<std::size_t>(row_blocks(n)));
    for_row_blocks(n, machine, [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
        std::int64_t i = std::max<std::int64_t>(first, 1);
        while (i < first + rows && neighborhoods.of(i).front() < i &&
               std::ranges::binary_search(neighborhoods.of(i), i))
            ++i;
        block_joins[static_cast<std::size_t>(block)] = i == first + rows ? 1 : 0;
    });
    return std::ranges::all_of(block_joins, [](char all) { return all != 0; });
}

Components one_component(std::int64_t n, const Machine& machine) {
    Components components;
    components.count = 1;
    components.of_frame.resize(static_cast<std::size_t>(n));
    components.position.resize(static_cast<std::size_t>(n));
    components.members.emplace_back(static_cast<std::size_t>(n));
    components.windows.emplace_back(static_cast<std::size_t>(n));
    for_row_blocks(n, machine, [&](std::int64_t, std::int64_t first, std::int64_t rows) {
        for (std::int64_t i = first; i < first + rows; ++i) {
            const auto frame = static_cast<std::size_t>(i);
            components.of_frame[frame] = 0;
            components.position[frame] = components.members[0][frame] =
                components.windows[0][frame] = static_cast<std::int32_t>(i);
        }
    });
    return components;
}

} // namespace

Components connected_components(const Neighborhoods& neighborhoods, const Machine& machine) {
    const std::int64_t n = neighborhoods.frames();
    if (each_frame_joins_an_earlier_one(neighborhoods, machine))
        return one_component(n, machine);
    DisjointSets sets(n);
    for (std::int64_t i = 0; i < n; ++i) {
        // Without include_self, frame i may be in no neighborhood: its own window describes the
        // motion around it but does not connect it.
        const auto members = neighborhoods.of(i);
        std::int32_t root = sets.find(members.front());
        for (const std::int32_t member : members)
            root = sets.unite(root, member);
    }
    Components components;
    components.of_frame = sets.release(); // parents, replaced below by numbers of components
    std::vector<std::int32_t> sizes;
    components.position.resize(static_cast<std::size_t>(n));
    for (std::int32_t i = 0; i < n; ++i) {
        std::int32_t& of_frame = components.of_frame[static_cast<std::size_t>(i)];
        if (of_frame == i) {
            of_frame = static_cast<std::int32_t>(sizes.size());
            sizes.push_back(0);
        } else {
            of_frame = components.of_frame[static_cast<std::size_t>(of_frame)];
        }
        components.position[static_cast<std::size_t>(i)] =
            sizes[static_cast<std::size_t>(of_frame)]++;
    }
    components.count = static_cast<std::int64_t>(sizes.size());
    for (const std::int32_t size : sizes)
        components.members.emplace_back(static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < components.position.size(); ++i)
        components.members[static_cast<std::size_t>(components.of_frame[i])]
                          [static_cast<std::size_t>(components.position[i])] =
            static_cast<std::int32_t>(i);
    components.windows.resize(sizes.size());
    for (std::int64_t i = 0; i < n; ++i) {
        const auto first = static_cast<std::size_t>(neighborhoods.of(i).front());
        components.windows[static_cast<std::size_t>(components.of_frame[first])].push_back(
            static_cast<std::int32_t>(i));
    }
    return components;
}

} // namespace stltsa::ltsa
