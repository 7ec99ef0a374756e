// SPDX-License-Identifier: BSD-3-Clause
// Callers' arrays, of any stride and type, to and from matrices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "stltsa.h"

namespace stltsa::capi {

/// The caller's frames as packed doubles; copied only if they are not packed doubles already.
class InputFrames {
  public:
    /// Throws Status::shape, argument, no_memory. `name` is the argument's name in messages.
    InputFrames(const stltsa_in* in, const char* name);
    ConstMatrixView view() const { return view_; }

  private:
    Matrix copy_;
    ConstMatrixView view_;
};

/// The caller's column of integers.
std::vector<std::int64_t> input_integers(const stltsa_in* in, const char* name);

/// Throws unless the caller's array holds numbers, is rows x cols and can be written.
void check_output(const stltsa_out* out, const char* name, std::int64_t rows, std::int64_t cols);
/// Throws unless the caller's array holds integers, is rows x 1 and can be written.
void check_integers(const stltsa_out* out, const char* name, std::int64_t rows);

/// Checks, then writes `values` (rows x cols) into the caller's array.
void write_output(const stltsa_out* out, const char* name, ConstMatrixView values);
/// The same for one column.
void write_column(const stltsa_out* out, const char* name, const std::vector<double>& values);
/// The same for a column of integers.
void write_integers(const stltsa_out* out, const char* name, std::span<const std::int64_t> values);

/// The same for an array of a handle; whole numbers may be written as real ones as well.
void write_array(const stltsa_out* out, const Matrix& values);
void write_array(const stltsa_out* out, std::span<const double> column);
void write_array(const stltsa_out* out, std::span<const std::int64_t> column);

/// The rows of each clip; NULL: one clip of all rows.
std::vector<std::int64_t> clip_lengths(const stltsa_in* lengths, std::int64_t rows);

/// Throws Status::argument unless `samples`, the number of samples per cycle, is within the limits.
void check_samples(std::int64_t samples, std::int64_t least = 2, std::int64_t most = 1'000'000);

} // namespace stltsa::capi
