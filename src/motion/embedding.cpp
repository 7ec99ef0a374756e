// SPDX-License-Identifier: BSD-3-Clause
#include "motion/embedding.hpp"

#include <algorithm>

#include "ltsa/embed.hpp"
#include "ltsa/fit.hpp"
#include "motion/choose_neighbors.hpp"

namespace stltsa::motion {
namespace {

/// Highest dimension that is tried.
constexpr int most_dimensions = 3;
/// One dimension needs three neighbors of each frame.
constexpr std::int64_t least_distinct = 4;

struct Dimensions {
    int first = 1;
    int last = 1;
};

/// A loop needs two coordinates, so at least one model has two.
Dimensions dimensions_to_try(std::optional<int> asked, bool repeats, std::int64_t neighbors) {
    if (asked)
        return {repeats ? std::min(*asked, 2) : *asked, std::max(*asked, 2)};
    // d dimensions need d + 2 neighbors. Without a period: two, as in Fig. 1 of the paper.
    const auto last =
        static_cast<int>(std::clamp<std::int64_t>(neighbors - 2, 1, repeats ? most_dimensions : 2));
    return {repeats ? 1 : last, last};
}

ltsa::Parameters parameters_for(std::int64_t neighbors, int dimension,
                                const DecomposeOptions& options) {
    ltsa::Parameters p;
    p.neighbors = neighbors;
    p.window = options.window.value_or(p.neighbors);
    p.dimension = dimension;
    p.mode = options.mode;
    p.exclusion = p.window;
    p.threads = options.threads;
    return p;
}

/// Limits the dimensions to the number of directions in which the samples vary, but not below a
/// requested dimension: embedding then fails.
Dimensions varying(const ltsa::Graph& graph, Dimensions wanted, std::optional<int> asked) {
    const int last =
        std::max(std::min(wanted.last, ltsa::varying_directions(graph)), asked.value_or(1));
    return {std::min(wanted.first, last), last};
}

/// Embeds the graph in each of the dimensions. For the eigengap, one of them computes more
/// eigenvalues than the fit needs, which saves another embedding.
void embed_graph(const ltsa::Graph& graph, Dimensions dimensions, const Progress& progress,
                 Embedding& result) {
    for (int d = dimensions.first; d <= dimensions.last; ++d) {
        const bool gap = result.intrinsic && result.intrinsic->parameters.dimension == d;
        const int of_fit = ltsa::eigenvalues_of_fit(d);
        ltsa::Model model = ltsa::embed(
            graph, d, gap ? std::max(of_fit, ltsa::eigenvalues_of_gap(graph, d)) : of_fit,
            progress.part(d - dimensions.first, dimensions.last - dimensions.first + 1));
        model.lengths = {result.span.count};
        auto& eigenvalues = model.components.front().eigenvalues;
        if (gap)
            ltsa::set_eigengap(graph, eigenvalues, *result.intrinsic);
        eigenvalues.resize(static_cast<std::size_t>(of_fit));
        result.models.push_back(std::move(model));
    }
}

void build_and_embed(ConstMatrixView samples, Dimensions dimensions,
                     const DecomposeOptions& options, const Progress& progress, Embedding& result) {
    ltsa::check_dimension(samples.cols, options.dimension.value_or(1));
    const std::int64_t parts = options.estimate ? 2 : 1;
    const ltsa::Graph graph =
        ltsa::build_graph(samples, {&samples.rows, 1}, result.parameters, progress.part(0, parts));
    if (options.estimate)
        result.intrinsic =
            ltsa::local_dimension(graph, options.dimension.value_or(ltsa::eigengap_tangents),
                                  *options.estimate, progress.part(1, parts));
    dimensions = varying(graph, dimensions, options.dimension);
    result.parameters.dimension = dimensions.last;
    embed_graph(graph, dimensions, progress, result);
}

} // namespace

Embedding embed(ConstMatrixView samples, double fps, Span span, const Period& period,
                const DecomposeOptions& options, const Progress& progress) {
    if (options.neighbors.value_or(0) >= span.count)
        span = {0, samples.rows};
    const ConstMatrixView embedded = samples.block(span.first, span.count);
    const std::int64_t distinct = distinct_frames(embedded);
    const std::int64_t neighbors =
        options.neighbors ? *options.neighbors
                          : choose_neighbors(period, fps, {distinct, 1, most_dimensions});
    const Dimensions dimensions =
        dimensions_to_try(options.dimension, period.samples > 0, neighbors);
    Embedding result{span, parameters_for(neighbors, dimensions.last, options), {}, {}, {}};
    if (distinct < least_distinct) {
        result.problem =
            format_text("no curve: only {} of {} samples are distinct", distinct, embedded.rows);
    } else {
        try {
            build_and_embed(embedded, dimensions, options, progress, result);
        } catch (const Error& error) {
            if (error.status() != Status::degenerate && error.status() != Status::disconnected)
                throw;
            result.models.clear();
            result.problem = options.dimension ? format_text("no curve of {} dimensions: {}",
                                                             *options.dimension, error.what())
                                               : format_text("no curve: {}", error.what());
        }
    }
    if (options.estimate && !result.intrinsic)
        result.intrinsic =
            ltsa::unknown_dimension(result.parameters, *options.estimate, result.problem);
    return result;
}

Matrix extended(const Matrix& coords, Span span, std::int64_t samples) {
    Matrix all(samples, coords.cols());
    for (std::int64_t i = 0; i < samples; ++i)
        std::copy_n(coords.row(std::clamp<std::int64_t>(i - span.first, 0, span.count - 1)),
                    coords.cols(), all.row(i));
    return all;
}

} // namespace stltsa::motion
