// SPDX-License-Identifier: BSD-3-Clause
// Dynamic mapping between frames and coordinates, both ways (paper, section 2.4): near a row of the
// model both are linear in each other. A point is placed by the stretch of the curve that it is
// nearest to, not by the nearest row: where the curve passes itself by, the nearest row is often
// one of the other part.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/mapping/timeline.hpp"
#include "ltsa/model.hpp"
#include "ltsa/search/nearest_rows.hpp"

namespace stltsa::ltsa {

struct MapParameters {
    std::int64_t neighbors = 10;  ///< rows that a local map rests on
    std::int64_t blend = 3;       ///< stretches whose maps are blended
    std::int64_t hint_window = 2; ///< rows to each side of a hint, repeated ones not counted
};

/// No hint: a point is looked for everywhere.
inline constexpr std::int64_t no_hint = -1;

/// A point as a combination of rows, of whatever a row of the model has: its coordinates, its
/// frame, its pose.
struct Placement {
    struct Term {
        std::int32_t row;
        double weight;
    };
    std::int64_t nearest = 0; ///< row; to a point of the curve the nearer end of its stretch
    double distance = 0;      ///< from the rows, over what is common; beyond 1 it is out of reach
    std::vector<Term> terms;

    /// t(nearest) + sum of weight (t(row) - t(nearest)): t(nearest) itself, to the bit, where there
    /// are no terms.
    void apply(ConstMatrixView targets, double* out) const;
};

/// The rows of a model, prepared for being looked up by frame and by coordinates. Any number of
/// threads may do so at once.
class Mapping {
  public:
    /// `frames`: those that the model was fitted to. Both must outlive this and stay where they
    /// are. `period` in rows, 0: none.
    Mapping(ConstMatrixView frames, const Model& model, double period);

    /// The distance of frames that Placement::distance 1 is.
    double reach() const { return frames_.limits.front(); }

    /// `hint`: row of the model near which the frame is looked for.
    Placement find_frame(const double* frame, std::int64_t hint, const MapParameters& p) const;
    /// Coordinates of different components are not comparable: `component` selects one. Throws
    /// Status::argument if none of its rows is near the hint.
    Placement find_point(const double* coords, std::int64_t component, std::int64_t hint,
                         const MapParameters& p) const;

  private:
    /// Where points are looked up: frames or coordinates.
    struct Space {
        ConstMatrixView rows;
        std::vector<NearestRows> parts; ///< a component each
        std::vector<double> limits;     ///< the same; for frames all are equal
        double ridge = 0;           ///< of the least squares, over the mean variance of a direction
        bool passes_itself = false; ///< rows that are near may be of poses that are not
    };

    static bool is_row(const Space& space, std::int64_t hint, const double* point);
    std::vector<Candidate> nearest_row(const NearestRows& part, const double* point,
                                       std::int64_t hint, const MapParameters& p) const;
    std::vector<NearStretch> nearest_stretches(const NearestRows& part, const double* point,
                                               std::int64_t hint, const MapParameters& p) const;
    std::size_t nearest_component(const double* frame, std::int64_t hint,
                                  const MapParameters& p) const;
    Placement find(const Space& space, std::size_t component, const double* point,
                   std::int64_t hint, const MapParameters& p) const;
    void add_local_map(const Space& space, std::size_t component, std::int64_t row,
                       const double* point, double weight, const MapParameters& p,
                       std::vector<Placement::Term>& terms) const;

    Timeline timeline_;
    Space frames_;
    Space coords_;
};

} // namespace stltsa::ltsa
