// SPDX-License-Identifier: BSD-3-Clause
// Tangents of large neighborhoods, by following their covariance matrices from frame to frame.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/covariance_batch.hpp"
#include "ltsa/tangents.hpp"

namespace stltsa::ltsa {

class TangentTrack {
  public:
    /// Frames, or a multiple of them, that find() is best given at a time: its lanes share them.
    static constexpr std::int64_t block = 512;

    /// Whether matrices of this many features are small enough beside neighborhoods of this size.
    static bool worth_while(std::int64_t size, std::int64_t features) {
        return features <= std::min<std::int64_t>(2 * size, 512);
    }

    /// Writes `count` eigenvalues of each frame's neighborhood, and the tangents.
    TangentTrack(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                 Simd simd, Matrix& values, Tangents& tangents);

    /// For the frames [first, last); returns those where it did not find them.
    std::vector<std::int64_t> find(std::int64_t first, std::int64_t last);

  private:
    void follow(std::int64_t begin, std::int64_t end, std::int64_t length,
                std::vector<std::int64_t>& missing);
    void begin_sequence(std::int64_t lane, std::int64_t frame);
    bool lost_digits(std::int64_t lane);
    void move_on(std::int64_t lane, std::int64_t frame);
    void write(std::int64_t lane, std::int64_t frame);

    ConstMatrixView x_;
    const Neighborhoods& neighborhoods_;
    std::int64_t count_;
    Simd simd_;
    Matrix& values_;
    Tangents& tangents_;
    CovarianceBatch batch_;
    Matrix origins_;                    ///< of each lane
    Matrix vectors_;                    ///< of one frame: count x features
    std::vector<double> largest_trace_; ///< of each lane's sequence
    std::vector<std::uint8_t> begins_;  ///< lanes whose sequence begins with the next frame
};

} // namespace stltsa::ltsa
