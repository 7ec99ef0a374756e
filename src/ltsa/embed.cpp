// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/embed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "ltsa/alignment/alignment.hpp"
#include "ltsa/alignment/patches.hpp"
#include "ltsa/spectrum/spectrum.hpp"
#include "ltsa/warnings.hpp"

namespace stltsa::ltsa {

namespace {

/// The sign of the entry of largest magnitude; of equal ones, the first.
double sign_of(std::span<const double> values, const Machine& machine) {
    const auto largest_of = [](std::span<const double> some) {
        return *std::ranges::max_element(some, {}, [](double v) { return std::abs(v); });
    };
    const auto count = static_cast<std::int64_t>(values.size());
    std::vector<double> largest(static_cast<std::size_t>(row_blocks(count)));
    for_row_blocks(count, machine, [&](std::int64_t block, std::int64_t first, std::int64_t rows) {
        largest[static_cast<std::size_t>(block)] = largest_of(
            values.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(rows)));
    });
    return largest_of(largest) < 0 ? -1 : 1;
}

/// Writes the eigenvectors to the members' rows of `coords` (Y, the output of Table 1). The sign of
/// a vector is arbitrary: its entry of largest magnitude is made positive.
void set_coords(const Matrix& vectors, std::span<const std::int32_t> members,
                const Machine& machine, Matrix& coords) {
    for (std::int64_t l = 0; l < vectors.rows(); ++l) {
        const double* values = vectors.row(l);
        const double sign = sign_of({values, members.size()}, machine);
        for_row_blocks(vectors.cols(), machine,
                       [&](std::int64_t, std::int64_t first, std::int64_t rows) {
                           for (std::int64_t i = first; i < first + rows; ++i)
                               coords(members[static_cast<std::size_t>(i)], l) = sign * values[i];
                       });
    }
}

/// The error of the tangents, which no correction can see, plus the error of the eigenvectors: in
/// differences, the first correction removes the rounding of B' and its factor. The grounded factor
/// is much less accurate, so its first correction says nothing about the error.
double error_estimate(const Spectrum& spectrum, std::size_t dimension, bool banded,
                      double rounding_of_tangents) {
    // Tangents turned by this angle cause eigenvalues of its square. If the first unwanted one is
    // not larger, or if corrections do not converge (on recorded clips they end below 1e-12),
    // nothing distinguishes the wanted eigenvectors from others.
    constexpr double largest_last_change = 1e-6;
    const bool is_noise = spectrum.values.size() > dimension &&
                          spectrum.values[dimension] < rounding_of_tangents * rounding_of_tangents;
    if (is_noise || spectrum.last_change > largest_last_change)
        return unknown_error;
    return std::max(banded ? spectrum.first_change : spectrum.last_change,
                    std::numeric_limits<double>::epsilon()) +
           rounding_of_tangents;
}

Component summarize(const Patches& patches, const Spectrum& spectrum, int dimension,
                    int eigenvalues) {
    Component component;
    component.frames = patches.frames();
    component.eigenvalues.assign(static_cast<std::size_t>(eigenvalues),
                                 std::numeric_limits<double>::quiet_NaN());
    component.eigenvalues[0] = 0;
    std::copy_n(spectrum.values.begin(),
                std::min(spectrum.values.size(), component.eigenvalues.size() - 1),
                component.eigenvalues.begin() + 1);
    component.residual = spectrum.residual;
    const auto d = static_cast<std::size_t>(dimension);
    if (component.eigenvalues.size() > d + 1)
        component.gap = component.eigenvalues[d + 1] / component.eigenvalues[d];
    component.rank_deficient_windows = patches.rank_deficient();
    component.solves = spectrum.solves;
    return component;
}

/// Table 1, step 4; Table 1, step 5: embeds a component and writes its rows of `coords` (distinct
/// frames x dimension).
Component embed_component(const Graph& graph, std::int64_t index, int dimension, int eigenvalues,
                          Matrix& coords) {
    const auto& members = graph.components.members[static_cast<std::size_t>(index)];
    const Machine machine{graph.parameters.simd, graph.parameters.threads};
    const Patches patches(graph.neighborhoods, graph.tangents, graph.components, index, dimension,
                          machine);
    if (patches.frames() < dimension + 2)
        fail(Status::disconnected,
             "a part of the neighborhood graph has {} frames, too few for {} coordinates; use more "
             "neighbors",
             patches.frames(), dimension);
    if (patches.rank_deficient() == patches.count())
        fail(Status::degenerate,
             "the frames vary in fewer than {} directions everywhere; use a "
             "lower dimension",
             dimension);
    report_progress(Stage::alignment, 0.0);
    const bool banded = graph.parameters.mode == Mode::temporal;
    const auto alignment =
        banded ? difference_alignment(patches, machine) : grounded_alignment(patches, machine);
    report_progress(Stage::alignment, 1.0);
    const Spectrum spectrum = smallest_eigenpairs(
        *alignment, std::min<std::int64_t>(eigenvalues - 1, patches.frames() - 1), dimension);
    set_coords(spectrum.vectors, members, machine, coords);
    Component component = summarize(patches, spectrum, dimension, eigenvalues);
    component.error_estimate =
        error_estimate(spectrum, static_cast<std::size_t>(dimension), banded,
                       graph.tangents.rounding[static_cast<std::size_t>(dimension - 1)]);
    return component;
}

/// Copies coordinates and components from the distinct frames to all frames.
void set_frames(const Graph& graph, const Matrix& coords, Model& model) {
    const auto& row_of = graph.frames.row_of;
    const auto frames = static_cast<std::int64_t>(row_of.size());
    model.coords = Matrix::unset(frames, coords.cols());
    model.component_of.resize(row_of.size());
    for_row_blocks(frames, {graph.parameters.simd, graph.parameters.threads},
                   [&](std::int64_t, std::int64_t first, std::int64_t rows) {
                       for (std::int64_t i = first; i < first + rows; ++i) {
                           const auto frame = static_cast<std::size_t>(i);
                           const auto row = static_cast<std::size_t>(row_of[frame]);
                           std::copy_n(coords.row(row_of[frame]), coords.cols(),
                                       model.coords.row(i));
                           model.component_of[frame] = graph.components.of_frame[row];
                       }
                   });
}

} // namespace

Model embed(const Graph& graph, int dimension, int eigenvalues) {
    Model model;
    model.parameters = graph.parameters;
    model.parameters.dimension = dimension;
    model.features = graph.frames.x.cols;
    model.repeated_frames = graph.frames.repeated;
    Matrix coords = Matrix::unset(graph.frames.x.rows, dimension);
    const std::int64_t count = graph.components.count;
    for (std::int64_t c = 0; c < count; ++c) {
        const PartOfStages part(c, count);
        model.components.push_back(embed_component(graph, c, dimension, eigenvalues, coords));
    }
    set_frames(graph, coords, model);
    model.time_correlation = time_correlation(graph, coords);
    model.warnings = warnings_of(graph, model);
    return model;
}

} // namespace stltsa::ltsa
