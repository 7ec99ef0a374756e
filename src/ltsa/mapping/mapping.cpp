// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/mapping/mapping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"
#include "ltsa/mapping/support.hpp"

namespace stltsa::ltsa {
namespace {

/// Directions whose variance is below this share of the neighborhood's largest are rounding noise.
constexpr double negligible_variance = 1e-8;

/// Ridge of the map from coordinates to frames: coordinates in which a neighborhood hardly varies
/// must not change the pose strongly.
constexpr double inverse_ridge = 1e-3;

/// The original rows of each component, each with the next one. If the order of rows has no
/// meaning, every row stands alone.
std::vector<std::vector<Segment>> segments_of_components(const Timeline& timeline,
                                                         const Model& model) {
    std::vector<std::vector<Segment>> segments(model.components.size());
    const auto component_of = [&](std::int64_t row) {
        return static_cast<std::size_t>(model.component_of[static_cast<std::size_t>(row)]);
    };
    for (const std::int32_t row : timeline.distinct()) {
        const std::int64_t next = timeline.next(row);
        const bool follows = next >= 0 && model.parameters.mode != Mode::spatial &&
                             component_of(next) == component_of(row);
        segments[component_of(row)].push_back(
            {row, follows ? static_cast<std::int32_t>(next) : row});
    }
    return segments;
}

std::vector<NearestRows> indexed(ConstMatrixView x,
                                 const std::vector<std::vector<Segment>>& segments) {
    std::vector<NearestRows> trees;
    trees.reserve(segments.size());
    for (const auto& of_component : segments)
        trees.emplace_back(x, of_component);
    return trees;
}

/// Weights of the `blend` nearest, with sum 1: 1/distance^2 minus its value at the next farther
/// one, so that the weight of a segment that leaves the blend has fallen to 0. If all are equally
/// far, all weights are equal.
std::vector<double> blend_weights(const std::vector<NearSegment>& found, std::size_t blend) {
    const double nearest = found.front().distance;
    const auto closeness = [nearest](const NearSegment& one) {
        return one.distance > nearest ? nearest / one.distance : 1;
    };
    const double cutoff = found.size() > blend ? closeness(found[blend]) : 0;
    std::vector<double> weights;
    double sum = 0;
    for (std::size_t i = 0; i < std::min(blend, found.size()); ++i) {
        weights.push_back(closeness(found[i]) - cutoff);
        sum += weights.back();
    }
    for (double& weight : weights)
        weight = sum > 0 ? weight / sum : 1 / static_cast<double>(weights.size());
    return weights;
}

/// The rows whose local maps are blended, with weights: both ends of each segment, interpolated at
/// its nearest point.
std::vector<Placement::Term> blended_rows(const std::vector<NearSegment>& found,
                                          std::size_t blend) {
    const std::vector<double> weights = blend_weights(found, blend);
    std::vector<Placement::Term> ends;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        ends.push_back({found[i].segment.row, weights[i] * (1 - found[i].share)});
        ends.push_back({found[i].segment.next, weights[i] * found[i].share});
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const auto& a, const auto& b) { return a.row < b.row; });
    std::vector<Placement::Term> rows;
    for (const Placement::Term& end : ends)
        if (!rows.empty() && rows.back().row == end.row)
            rows.back().weight += end.weight;
        else
            rows.push_back(end);
    return rows;
}

/// The rows of a neighborhood minus their mean.
Matrix centered_rows(ConstMatrixView x, const std::vector<Candidate>& neighborhood,
                     const double* origin) {
    Matrix rows(static_cast<std::int64_t>(neighborhood.size()), x.cols);
    AlignedVector<double> mean(static_cast<std::size_t>(x.cols));
    for (std::int64_t a = 0; a < rows.rows(); ++a) {
        // Relative to the origin first, so that a large common offset costs no digits.
        const double* row = x.row(neighborhood[static_cast<std::size_t>(a)].frame);
        for (std::int64_t c = 0; c < x.cols; ++c)
            rows(a, c) = row[c] - origin[c];
        axpy(1 / static_cast<double>(rows.rows()), rows.row(a), mean.data(), x.cols);
    }
    for (std::int64_t a = 0; a < rows.rows(); ++a)
        axpy(-1, mean.data(), rows.row(a), x.cols);
    return rows;
}

/// Applies to `offset` the least-squares linear map from centered rows Z to any values of the rows
/// and returns the weights of these values. With Z Z^T = sum of lambda_l v_l v_l^T they are the sum
/// over the first `dimension` terms v_l (v_l . Z offset) / (lambda_l + ridge).
std::vector<double> least_squares_weights(const Matrix& z, const double* offset,
                                          std::int64_t dimension, double relative_ridge) {
    const std::int64_t count = z.rows();
    std::vector<double> weights(static_cast<std::size_t>(count));
    AlignedVector<double> along(static_cast<std::size_t>(count));
    TopEigenpairs eigen(count, std::min(dimension, count));
    double trace = 0;
    for (std::int64_t a = 0; a < count; ++a) {
        along[static_cast<std::size_t>(a)] = dot(z.row(a), offset, z.cols());
        for (std::int64_t b = a; b < count; ++b)
            eigen.matrix()[a * count + b] = dot(z.row(a), z.row(b), z.cols());
        trace += eigen.matrix()[a * count + a];
    }
    if (!(trace > 0) || !std::isfinite(trace))
        return weights;
    eigen.solve();
    const double ridge = relative_ridge * trace / static_cast<double>(dimension);
    for (std::int64_t l = 0; l < std::min(dimension, count); ++l)
        if (eigen.value(l) > negligible_variance * eigen.value(0))
            axpy(dot(eigen.vector(l), along.data(), count) / (eigen.value(l) + ridge),
                 eigen.vector(l), weights.data(), count);
    return weights;
}

} // namespace

void Placement::apply(ConstMatrixView targets, double* out) const {
    const double* origin = targets.row(nearest);
    std::copy_n(origin, targets.cols, out);
    for (const Term& term : terms) {
        const double* row = targets.row(term.row);
        for (std::int64_t c = 0; c < targets.cols; ++c)
            out[c] += term.weight * (row[c] - origin[c]);
    }
}

Mapping::Mapping(ConstMatrixView frames, const Model& model, double period)
    : timeline_(frames, model.lengths) {
    const auto segments = segments_of_components(timeline_, model);
    const Mode mode = model.parameters.mode;
    frames_ = {frames, indexed(frames, segments), {}, 0, false};
    frames_.limits.assign(segments.size(),
                          support_limit(frames, frames_.trees, timeline_, mode, period));
    const ConstMatrixView coords = model.coords.view();
    coords_ = {coords, indexed(coords, segments), {}, inverse_ridge, true};
    for (const NearestRows& tree : coords_.trees)
        coords_.limits.push_back(support_limit(coords, {&tree, 1}, timeline_, mode, period));
}

Placement Mapping::find_frame(const double* frame, std::int64_t hint,
                              const MapParameters& p) const {
    if (is_row(frames_, hint, frame))
        return {timeline_.original(hint), 0, {}};
    const std::size_t component = frames_.trees.size() == 1 ? 0 : nearest_component(frame, hint, p);
    return find(frames_, component, frame, hint, p);
}

Placement Mapping::find_point(const double* coords, std::int64_t component, std::int64_t hint,
                              const MapParameters& p) const {
    const auto index = static_cast<std::size_t>(component);
    if (is_row(coords_, hint, coords) && coords_.trees[index].contains(timeline_.original(hint)))
        return {timeline_.original(hint), 0, {}};
    return find(coords_, index, coords, hint, p);
}

/// If several rows are equal, the hint decides.
bool Mapping::is_row(const Space& space, std::int64_t hint, const double* point) {
    return hint != no_hint && squared_distance(space.rows.row(hint), point, space.rows.cols) == 0;
}

std::vector<Candidate> Mapping::nearest_row(const NearestRows& tree, const double* point,
                                            std::int64_t hint, const MapParameters& p) const {
    return hint == no_hint ? tree.nearest(point, 1)
                           : tree.nearest_within(point, 1, timeline_.around(hint, p.hint_window));
}

/// The segments to blend and one more, for blend_weights().
std::vector<NearSegment> Mapping::nearest_segments(const NearestRows& tree, const double* point,
                                                   std::int64_t hint,
                                                   const MapParameters& p) const {
    return hint == no_hint ? tree.nearest_segments(point, p.blend + 1)
                           : tree.nearest_segments_within(point, p.blend + 1,
                                                          timeline_.around(hint, p.hint_window));
}

std::size_t Mapping::nearest_component(const double* frame, std::int64_t hint,
                                       const MapParameters& p) const {
    std::size_t nearest = 0;
    Candidate best{std::numeric_limits<double>::infinity(),
                   std::numeric_limits<std::int32_t>::max()};
    for (std::size_t c = 0; c < frames_.trees.size(); ++c)
        for (const Candidate& found : nearest_row(frames_.trees[c], frame, hint, p))
            if (found < best) {
                best = found;
                nearest = c;
            }
    return nearest;
}

Placement Mapping::find(const Space& space, std::size_t component, const double* point,
                        std::int64_t hint, const MapParameters& p) const {
    const NearestRows& tree = space.trees[component];
    const auto rows = nearest_row(tree, point, hint, p);
    if (rows.empty())
        fail(Status::argument, "no row of component {} is within {} rows of the hint {}", component,
             p.hint_window, hint);
    Placement placement;
    placement.nearest = rows.front().frame;
    const double distance = std::sqrt(rows.front().distance);
    if (distance == 0)
        return placement;
    placement.distance = distance / space.limits[component];
    if (!std::isfinite(rows.front().distance))
        return placement;
    const auto found = nearest_segments(tree, point, hint, p);
    if (space.crosses_itself)
        placement.nearest = found.front().nearer_end();
    for (const auto& [row, weight] : blended_rows(found, static_cast<std::size_t>(p.blend)))
        if (weight > 0)
            add_local_map(space, component, row, point, weight, p, placement.terms);
    return placement;
}

void Mapping::add_local_map(const Space& space, std::size_t component, std::int64_t row,
                            const double* point, double weight, const MapParameters& p,
                            std::vector<Placement::Term>& terms) const {
    // Uses neighbors of the frame here as well: rows that are near in a few coordinates may have
    // different frames, as in a swing forward and back.
    const auto neighborhood = frames_.trees[component].nearest(frames_.rows.row(row), p.neighbors);
    const double* origin = space.rows.row(row);
    AlignedVector<double> offset(static_cast<std::size_t>(space.rows.cols));
    for (std::size_t c = 0; c < offset.size(); ++c)
        offset[c] = point[c] - origin[c];
    const auto slope = least_squares_weights(centered_rows(space.rows, neighborhood, origin),
                                             offset.data(), coords_.rows.cols, space.ridge);
    double own = 1;
    for (std::size_t a = 0; a < slope.size(); ++a) {
        terms.push_back({neighborhood[a].frame, weight * slope[a]});
        own -= slope[a];
    }
    terms.push_back({static_cast<std::int32_t>(row), weight * own});
}

} // namespace stltsa::ltsa
