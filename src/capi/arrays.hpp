// SPDX-License-Identifier: BSD-3-Clause
// Callers' arrays of any stride and of either float type, to and from our own matrices.
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/matrix.hpp"
#include "stltsa.h"

namespace stltsa::capi {

/// The caller's frames as packed doubles; copied only where they are not that already.
class InputFrames {
  public:
    /// Throws Status::shape, argument, no_memory. `name` is the argument's name in messages.
    InputFrames(const stltsa_in* in, const char* name);
    ConstMatrixView view() const { return view_; }

  private:
    Matrix copy_;
    ConstMatrixView view_;
};

/// Throws unless the caller's array is rows x cols and can be written.
void check_output(const stltsa_out* out, const char* name, std::int64_t rows, std::int64_t cols);

/// Checks, then writes `values` (rows x cols) into the caller's array.
void write_output(const stltsa_out* out, const char* name, ConstMatrixView values);
/// The same for one column.
void write_column(const stltsa_out* out, const char* name, const std::vector<double>& values);

/// `lengths[clips]`, or one clip of all rows where lengths is NULL.
std::vector<std::int64_t> clip_lengths(const std::int64_t* lengths, std::int64_t clips,
                                       std::int64_t rows);

} // namespace stltsa::capi
