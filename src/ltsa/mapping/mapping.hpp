// SPDX-License-Identifier: BSD-3-Clause
// Dynamic mapping from frames to coordinates and back (paper, section 2.4): near a row of the model
// each is a linear function of the other. A point is mapped by the nearest segment of the curve,
// not by the nearest row: where the curve crosses itself, the nearest row is often on the other
// branch.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/mapping/timeline.hpp"
#include "ltsa/model.hpp"
#include "ltsa/search/nearest_rows.hpp"

namespace stltsa::ltsa {

struct MapParameters {
    std::int64_t neighbors = 10;  ///< rows that determine a local map
    std::int64_t blend = 3;       ///< segments whose maps are blended
    std::int64_t hint_window = 2; ///< rows on each side of a hint, not counting repeated ones
};

/// No hint: all rows are searched.
inline constexpr std::int64_t no_hint = -1;

/// A point as a combination of rows, which applies to everything that a row has: its coordinates,
/// its frame, its pose.
struct Placement {
    struct Term {
        std::int32_t row;
        double weight;
    };
    std::int64_t nearest = 0; ///< row; for coordinates the nearer end of the nearest segment
    double distance = 0;      ///< from the nearest row, relative to the reach
    std::vector<Term> terms;

    /// out := t(nearest) + sum of weight (t(row) - t(nearest)); without terms t(nearest) to the
    /// bit.
    void apply(ConstMatrixView targets, double* out) const;
};

/// The rows of a model, searchable by frame and by coordinates, from any number of threads at once.
class Mapping {
  public:
    /// `frames`: those that the model was fitted to. Keeps references to both. `period`: in rows;
    /// 0: none.
    Mapping(ConstMatrixView frames, const Model& model, double period);

    /// The distance between frames that corresponds to Placement::distance 1.
    double reach() const { return frames_.limits.front(); }

    /// `hint`: the row of the model near which to search.
    Placement find_frame(const double* frame, std::int64_t hint, const MapParameters& p) const;
    /// Coordinates of different components are not comparable: `component` selects one. Throws
    /// Status::argument if none of its rows is near the hint.
    Placement find_point(const double* coords, std::int64_t component, std::int64_t hint,
                         const MapParameters& p) const;

  private:
    /// The rows to search: frames or coordinates.
    struct Space {
        ConstMatrixView rows;
        std::vector<NearestRows> trees; ///< one per component
        std::vector<double> limits;     ///< reach, one per component; for frames all are equal
        double ridge = 0;               ///< relative to the mean variance of a direction
        bool crosses_itself = false;    ///< near rows may have different poses
    };

    static bool is_row(const Space& space, std::int64_t hint, const double* point);
    std::vector<Candidate> nearest_row(const NearestRows& tree, const double* point,
                                       std::int64_t hint, const MapParameters& p) const;
    std::vector<NearSegment> nearest_segments(const NearestRows& tree, const double* point,
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
