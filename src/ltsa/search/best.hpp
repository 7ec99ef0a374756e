// SPDX-License-Identifier: BSD-3-Clause
// Collects the nearest results of a search.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace stltsa::ltsa {

/// A frame that may become a neighbor.
struct Candidate {
    double distance;
    std::int32_t frame;
    /// Nearer first, ties by frame number.
    bool operator<(const Candidate& other) const {
        return distance < other.distance || (distance == other.distance && frame < other.frame);
    }
};

/// The `count` smallest of the offered elements, as a heap with the largest on top.
template <class Found>
class Best {
  public:
    explicit Best(std::size_t count) : count_(count) { heap_.reserve(count); }

    /// Elements farther than this cannot be among them.
    double reach() const {
        return heap_.size() == count_ ? heap_.front().distance
                                      : std::numeric_limits<double>::infinity();
    }
    void offer(const Found& found) {
        if (heap_.size() == count_) {
            if (!(found < heap_.front()))
                return;
            std::pop_heap(heap_.begin(), heap_.end());
            heap_.back() = found;
        } else {
            heap_.push_back(found);
        }
        std::push_heap(heap_.begin(), heap_.end());
    }
    /// Ends the search; smallest first.
    std::vector<Found> sorted() {
        std::sort_heap(heap_.begin(), heap_.end());
        return std::move(heap_);
    }

  private:
    std::size_t count_;
    std::vector<Found> heap_;
};

} // namespace stltsa::ltsa
