// SPDX-License-Identifier: BSD-3-Clause
// Gaps: points, or columns of a matrix, that have no value in some frames.
#pragma once

#include <cstdint>
#include <vector>

#include "clip/clip.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::clip {

/// Same values as STLTSA_GAPS_* (checked in capi).
enum class GapRule : std::int32_t {
    fill = 1,   ///< short gaps are filled over time, longer ones predicted
    refuse = 2, ///< a gap is an error
    skip = 3,   ///< all are predicted, so that they add nothing to distances
};

/// Longer gaps are not filled over time. Straight lines over 0.25 s move the borders of strides by
/// no more than noise does: 1 to 3 ms at the median (measure/gaps).
constexpr double longest_filled_s = 0.25;

/// Frames a second, if the clip does not give them.
constexpr double usual_rate = 100;

/// Frames [begin, end) of a clip.
struct Frames {
    std::int64_t begin = 0;
    std::int64_t end = 0;

    std::int64_t count() const { return end - begin; }
    bool operator==(const Frames&) const = default;
};

/// A gap in the columns of one group: a point, or a column of a matrix.
struct Gap : Frames {
    std::int64_t group = 0;
};

/// The result of fill_gaps(). Points are groups of two or three columns; is_missing() decides which
/// are missing.
struct Gaps {
    std::vector<std::int64_t> seen;    ///< groups that take part
    std::vector<std::int64_t> filled;  ///< those of them that were missing in some frames
    std::vector<std::int64_t> dropped; ///< missing in more than half of the frames with the body
    std::int64_t frames = 0;           ///< frames in which a group is missing, summed over `seen`
    /// Where more than half of the groups are missing for longer than longest_filled_s: nothing is
    /// known of the body.
    std::vector<Frames> holes;
    Frames kept;                ///< between_end_holes(): those that fill_gaps() leaves
    std::vector<Gap> predicted; ///< gaps for predict_gaps(), in frames after kept.begin
};

/// The frames after a hole at the start and before one at the end. A hole is never the whole clip.
Frames between_end_holes(const std::vector<Frames>& holes, std::int64_t frames);

/// Takes the frames before the body comes and after it has left from the rows. In the others, fills
/// all gaps linearly over time, and with the nearest value at the ends. Sets the columns of dropped
/// groups to 0, so that they carry no weight and the others keep their places. `width`: columns of
/// a group. `fps` 0: unknown.
Gaps fill_gaps(Matrix& rows, int width, GapRule rule, double fps);

/// Replaces what fill_gaps() put into the gaps listed as `predicted` by what the groups that are
/// there imply: the conditional mean under the covariance of the rows, found by iteration
/// (Dempster, Laird and Rubin, "Maximum likelihood from incomplete data via the EM algorithm",
/// 1977; for markers, Gloersen and Federolf, "Predicting missing marker trajectories in human
/// motion data using marker intercorrelations", PLOS ONE, 2016). So a distance between two frames
/// is that of what both have. Of many groups, those near the missing one are used, so that time and
/// memory grow with the number of groups only. The rows must be relative to the body.
void predict_gaps(Matrix& rows, int width, const Gaps& gaps);

/// Rows for all frames of a clip: those that fill_gaps() took away are as the nearest ones.
Matrix with_all_frames(Matrix rows, const Frames& kept, std::int64_t frames);

} // namespace stltsa::clip
