// SPDX-License-Identifier: BSD-3-Clause
// The motion in few columns, its velocity, and how fast it usually is around each moment.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::motion {

struct Signal {
    Matrix poses;              ///< rows x leading directions of poses and velocities
    Matrix velocity;           ///< of the lightly smoothed poses, per row
    std::vector<double> speed; ///< length of the velocity, smoothed
    std::vector<double> usual; ///< typical speed within some seconds of each row; 0: nothing moves
    std::vector<double> near_usual; ///< the same within less time, but not far below `usual`
    std::vector<double> side;       ///< see side_motion(); empty: unknown
    std::vector<double> one_side, other_side; ///< the same of each side alone
    std::optional<bool> forward;              ///< see Options
    bool begin_with_side = false;             ///< see Options
    double rate = 0;                          ///< rows a second
    std::int64_t step = 1;                    ///< samples per row
    Matrix directions;                        ///< columns of the samples x columns of poses

    std::int64_t rows() const { return poses.rows(); }
    std::int64_t cols() const { return poses.cols(); }
};

/// `samples`: frames x features at `fps`, smoothed by a Gaussian of `smoothed_s`, of a body of
/// this size (Options). At most about 30 rows a second are kept.
Signal make_signal(ConstMatrixView samples, double fps, double smoothed_s, double size);

/// [begin, end) in rows.
struct Rows {
    std::int64_t begin = 0;
    std::int64_t end = 0;

    std::int64_t count() const { return end - begin; }
    bool operator==(const Rows&) const = default;
};

/// Reports progress through the rows, some of which are visited again.
void report_row(const Signal& signal, double row);

/// The row at `place`, interpolated linearly; places beyond the ends give the end rows.
void row_at(ConstMatrixView rows, double place, double* values);

/// Poses at equally spaced places from `begin` on, before `end`.
Matrix rows_at(ConstMatrixView rows, double begin, double end, std::int64_t count);

} // namespace stltsa::motion
