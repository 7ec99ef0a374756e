// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a glTF file: one block of bytes, and the lists that say what is where.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/json.hpp"

namespace stltsa::clip {

/// The number in the 32 bits that glTF has for it. Status::unsupported if it is too large for them.
float narrow(double value);

/// The times of these frames, in seconds. Status::unsupported if two are the same in 32 bits.
std::vector<float> gltf_times(const std::vector<std::int64_t>& frames, double fps);

class GltfBuffer {
  public:
    /// Appends vectors of `components` numbers; returns the index of their accessor.
    int add(int components, const std::vector<float>& values);

    const std::string& bytes() const { return bytes_; }
    /// Sets "buffers", "bufferViews" and "accessors".
    void describe(JsonObject& file) const;

  private:
    std::string bytes_;
    std::vector<Json> views_, accessors_;
};

} // namespace stltsa::clip
