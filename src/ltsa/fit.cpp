// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/fit.hpp"

#include "ltsa/embed.hpp"

namespace stltsa::ltsa {

std::int64_t first_cut(const Model& model) {
    std::int64_t first = 0;
    for (const std::int64_t length : model.lengths) {
        for (std::int64_t i = first + 1; i < first + length; ++i)
            if (model.component_of[static_cast<std::size_t>(i)] !=
                model.component_of[static_cast<std::size_t>(i - 1)])
                return i;
        first += length;
    }
    return -1;
}

void check_dimension(std::int64_t features, int dimension) {
    if (dimension > features)
        fail(
            Status::degenerate,
            "{} coordinates were requested, but the frames have {} features; use a dimension of at "
            "most {}",
            dimension, features, features);
}

Model fit(ConstMatrixView frames, std::span<const std::int64_t> lengths,
          const Parameters& parameters) {
    check_dimension(frames.cols, parameters.dimension);
    const Graph graph = build_graph(frames, lengths, parameters);
    Model model = embed(graph, parameters.dimension, eigenvalues_of_fit(parameters.dimension));
    model.lengths.assign(lengths.begin(), lengths.end());
    return model;
}

} // namespace stltsa::ltsa
