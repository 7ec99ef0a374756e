// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/dimension.hpp"

#include <algorithm>

#include "base/progress.hpp"
#include "ltsa/embed.hpp"
#include "ltsa/tangents/local_tangents.hpp"

namespace stltsa::ltsa {
namespace {

/// Eigenvalues beyond the tangent dimension: enough to show the gap.
constexpr int eigenvalues_beyond = 5;
/// Neighborhoods used for local PCA: more of them do not change the median.
constexpr std::int64_t sampled_neighborhoods = 1000;
/// Directions whose variance is reported.
constexpr std::int64_t listed_variances = 10;

/// The smallest d with lambda_{d+1} - lambda_d > tau, with lambda_1 = 0 (paper, section 2.3).
int first_gap(const std::vector<double>& scaled, double threshold) {
    for (std::size_t d = 1; d < scaled.size(); ++d)
        if (scaled[d] - scaled[d - 1] > threshold)
            return static_cast<int>(d);
    return 0;
}

/// The number of directions that explain `share` of the sum of a descending spectrum; 0 if it is
/// zero.
int explaining_directions(const double* spectrum, std::int64_t count, double share) {
    double total = 0;
    for (std::int64_t l = 0; l < count; ++l)
        total += spectrum[l];
    double explained = 0;
    for (std::int64_t l = 0; l < count && total > 0; ++l) {
        explained += spectrum[l];
        if (explained >= share * total)
            return static_cast<int>(l + 1);
    }
    return 0;
}

void local_pca(const Graph& graph, Dimension& result) {
    const std::int64_t n = graph.frames.x.rows;
    const std::int64_t count = std::min(graph.neighborhoods.size, graph.frames.x.cols);
    const std::int64_t stride = std::max<std::int64_t>(1, n / sampled_neighborhoods);
    const Matrix spectra =
        local_spectra(graph.frames.x, graph.neighborhoods, count, stride, graph.parameters.threads);
    std::vector<int> dimensions;
    result.local_variances.assign(static_cast<std::size_t>(std::min(count, listed_variances)), 0);
    for (std::int64_t i = 0; i < spectra.rows(); ++i) {
        const int d = explaining_directions(spectra.row(i), count, result.local_variance);
        if (d == 0)
            continue;
        dimensions.push_back(d);
        double total = 0;
        for (std::int64_t l = 0; l < count; ++l)
            total += spectra(i, l);
        for (std::size_t l = 0; l < result.local_variances.size(); ++l)
            result.local_variances[l] += spectra(i, static_cast<std::int64_t>(l)) / total;
    }
    if (dimensions.empty()) {
        result.local_pca_reason = "no neighborhood varies";
        return;
    }
    for (double& share : result.local_variances)
        share /= static_cast<double>(dimensions.size());
    const auto middle = dimensions.begin() + static_cast<std::ptrdiff_t>(dimensions.size() / 2);
    std::nth_element(dimensions.begin(), middle, dimensions.end());
    result.local_pca = *middle;
}

/// The reason why the eigengap does not determine the dimension; empty: it does.
std::string no_eigengap(const Graph& graph, int tangents) {
    if (graph.components.count > 1)
        return format_text(
            "the neighborhood graph has {} parts, each with its own zero eigenvalue: the gap would "
            "count the parts, not the dimension",
            graph.components.count);
    if (varying_directions(graph) < tangents)
        return format_text("every window varies in fewer than {} directions", tangents);
    return {};
}

Dimension unestimated(const Parameters& parameters, const DimensionOptions& options) {
    Dimension result;
    result.parameters = parameters;
    result.threshold = options.threshold;
    result.local_variance = options.local_variance;
    return result;
}

} // namespace

int eigenvalues_of_gap(const Graph& graph, int tangents) {
    return static_cast<int>(
        std::min<std::int64_t>(tangents + eigenvalues_beyond, graph.frames.x.rows));
}

Dimension local_dimension(const Graph& graph, int tangents, const DimensionOptions& options) {
    Dimension result = unestimated(graph.parameters, options);
    result.parameters.dimension = tangents;
    local_pca(graph, result);
    result.eigengap_reason = no_eigengap(graph, tangents);
    return result;
}

void set_eigengap(const Graph& graph, std::span<const double> eigenvalues, Dimension& result) {
    if (!result.eigengap_reason.empty())
        return;
    const auto k = static_cast<double>(graph.neighborhoods.size);
    for (const double value : eigenvalues)
        result.eigenvalues.push_back(value / k);
    result.eigengap = first_gap(result.eigenvalues, result.threshold);
    if (result.eigengap == 0)
        result.eigengap_reason = format_text("no gap among the first {} eigenvalues exceeds {} k",
                                             result.eigenvalues.size(), result.threshold);
}

Dimension unknown_dimension(const Parameters& parameters, const DimensionOptions& options,
                            const std::string& reason) {
    Dimension result = unestimated(parameters, options);
    result.eigengap_reason = result.local_pca_reason = reason;
    return result;
}

Dimension intrinsic_dimension(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                              const Parameters& parameters, const DimensionOptions& options) {
    try {
        const int tangents = parameters.dimension;
        const auto in_part = [](std::int64_t index, const auto& work) {
            const PartOfStages part(index, 2);
            return work();
        };
        const Graph graph = in_part(0, [&] { return build_graph(frames, lengths, parameters); });
        Dimension result = in_part(1, [&] { return local_dimension(graph, tangents, options); });
        if (result.eigengap_reason.empty()) {
            const int count = eigenvalues_of_gap(graph, tangents);
            const Model model = embed(graph, tangents, count);
            set_eigengap(graph, model.components.front().eigenvalues, result);
        }
        return result;
    } catch (const Error& error) {
        if (error.status() != Status::degenerate && error.status() != Status::disconnected)
            throw;
        return unknown_dimension(parameters, options, error.what());
    }
}

} // namespace stltsa::ltsa
