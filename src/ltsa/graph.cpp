// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/graph.hpp"

#include <algorithm>
#include <limits>

#include "base/progress.hpp"
#include "ltsa/tangents/local_tangents.hpp"

namespace stltsa::ltsa {

namespace {

/// Table 1, step 1; Table 1, step 2; Table 1, step 3.
void find_neighbors_and_tangents(const Parameters& parameters, Graph& graph) {
    const ConstMatrixView x = graph.frames.x;
    const std::vector<std::int64_t>& lengths = graph.frames.lengths;
    // The first half of stage "neighbors" is the choice of k.
    const PartOfStages search(1, 2);
    switch (parameters.mode) {
    case Mode::temporal:
        graph.tangents = temporal_tangents(x, lengths, parameters, graph.neighborhoods);
        return;
    case Mode::spatial:
        graph.neighborhoods = spatial_neighbors(x, parameters);
        break;
    case Mode::recurrent:
        graph.neighborhoods = recurrent_neighbors(x, lengths, parameters);
        break;
    }
    graph.tangents = local_tangents(x, graph.neighborhoods, parameters);
}

} // namespace

Graph build_graph(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                  const Parameters& parameters) {
    Graph graph;
    graph.parameters = parameters;
    graph.frames = collapse_repeats(frames, lengths, parameters.threads);
    check_parameters(parameters, graph.frames);
    scale_tiny(graph.frames);
    // A window larger than the clip would only take memory.
    Parameters within = parameters;
    within.window = std::min(parameters.window, graph.frames.x.rows);
    find_neighbors_and_tangents(within, graph);
    graph.components =
        connected_components(graph.neighborhoods, {parameters.simd, parameters.threads});
    return graph;
}

int varying_directions(const Graph& graph) {
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    for (const auto& windows : graph.components.windows) {
        std::int32_t most = 0;
        for (const std::int32_t window : windows)
            most = std::max(most, graph.tangents.rank[static_cast<std::size_t>(window)]);
        least = std::min(least, most);
    }
    return least;
}

} // namespace stltsa::ltsa
