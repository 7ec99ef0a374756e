// SPDX-License-Identifier: BSD-3-Clause
#include "base/npy_bytes.hpp"
#include "clip/clip.hpp"

namespace stltsa::clip {

std::string format_npy(const Clip& clip, const Progress&) {
    return npy_bytes(clip.values.data(), clip.values.rows(), clip.values.cols(), clip.space);
}

} // namespace stltsa::clip
