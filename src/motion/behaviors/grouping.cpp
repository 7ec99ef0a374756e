// SPDX-License-Identifier: BSD-3-Clause
#include "motion/behaviors/grouping.hpp"

#include <algorithm>
#include <limits>

#include "base/checkpoint.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::motion {
namespace {

constexpr std::int64_t most_linked = 2000;

/// Distances between clusters; merging keeps the mean over all pairs of items.
class Clusters {
  public:
    Clusters(std::int64_t count, const std::function<double(std::int64_t, std::int64_t)>& distance)
        : distances_(count, count), sizes_(static_cast<std::size_t>(count), 1) {
        for (std::int64_t i = 0; i < count; ++i) {
            checkpoint();
            for (std::int64_t k = 0; k < i; ++k)
                distances_(i, k) = distances_(k, i) = distance(i, k);
        }
    }

    bool alive(std::int64_t i) const { return sizes_[static_cast<std::size_t>(i)] > 0; }

    /// -1: none.
    std::int64_t nearest(std::int64_t i) const {
        std::int64_t found = -1;
        for (std::int64_t k = 0; k < distances_.rows(); ++k)
            if (k != i && alive(k) && (found < 0 || distances_(i, k) < distances_(i, found)))
                found = k;
        return found;
    }
    double distance(std::int64_t i, std::int64_t k) const { return distances_(i, k); }

    void merge(std::int64_t into, std::int64_t from) {
        const double a = sizes_[static_cast<std::size_t>(into)];
        const double b = sizes_[static_cast<std::size_t>(from)];
        for (std::int64_t k = 0; k < distances_.rows(); ++k)
            distances_(into, k) = distances_(k, into) =
                (a * distances_(into, k) + b * distances_(from, k)) / (a + b);
        sizes_[static_cast<std::size_t>(into)] += sizes_[static_cast<std::size_t>(from)];
        sizes_[static_cast<std::size_t>(from)] = 0;
    }

  private:
    Matrix distances_;
    std::vector<int> sizes_;
};

/// Average linkage by chains of nearest neighbors. A merge is done only if it is within `most`;
/// heights of average linkage do not fall, so that a cluster whose nearest is farther is complete.
std::vector<std::int64_t> linked(Clusters& clusters, std::int64_t count, double most) {
    std::vector<std::int64_t> parent(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i)
        parent[static_cast<std::size_t>(i)] = i;
    std::vector<bool> complete(static_cast<std::size_t>(count), false);
    for (std::int64_t start = 0; start < count; ++start) {
        while (clusters.alive(start) && !complete[static_cast<std::size_t>(start)]) {
            std::int64_t a = start, b = clusters.nearest(a);
            while (b >= 0) {
                const std::int64_t c = clusters.nearest(b);
                if (c < 0 || clusters.distance(b, c) >= clusters.distance(a, b))
                    break;
                a = b;
                b = c;
            }
            if (b < 0 || clusters.distance(a, b) > most) {
                complete[static_cast<std::size_t>(a)] = true;
                if (a != start)
                    break;
                continue;
            }
            clusters.merge(std::min(a, b), std::max(a, b));
            parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        }
    }
    return parent;
}

} // namespace

std::vector<int> group(std::int64_t count, double most,
                       const std::function<double(std::int64_t, std::int64_t)>& distance) {
    const std::int64_t first = std::min(count, most_linked);
    Clusters clusters(first, distance);
    std::vector<std::int64_t> parent = linked(clusters, first, most);
    for (std::int64_t i = first; i < count; ++i) {
        checkpoint();
        std::int64_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::int64_t k = 0; k < first; ++k)
            if (const double d = distance(i, k); d < least) {
                least = d;
                nearest = k;
            }
        parent.push_back(least <= most ? nearest : i);
    }
    std::vector<int> groups;
    int next = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t above = parent[static_cast<std::size_t>(i)];
        groups.push_back(above == i ? next++ : groups[static_cast<std::size_t>(above)]);
    }
    return groups;
}

} // namespace stltsa::motion
