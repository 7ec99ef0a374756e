// SPDX-License-Identifier: BSD-3-Clause
#include "clip/gltf/buffer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/error.hpp"

namespace stltsa::clip {
namespace {

const char* type_of(int components) {
    switch (components) {
    case 1:
        return "SCALAR";
    case 3:
        return "VEC3";
    case 4:
        return "VEC4";
    default:
        return "MAT4";
    }
}

/// The least or the largest of each component, by `better`.
template <class Better>
std::vector<double> bound(std::size_t components, const std::vector<float>& values, Better better) {
    std::vector<double> best(values.begin(),
                             values.begin() + static_cast<std::ptrdiff_t>(components));
    for (std::size_t i = components; i < values.size(); ++i)
        best[i % components] =
            std::min(best[i % components], static_cast<double>(values[i]), better);
    return best;
}

void append_little_endian(std::string& bytes, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(bits >> shift & 0xff);
}

} // namespace

float narrow(double value) {
    const auto result = static_cast<float>(value);
    if (!std::isfinite(result))
        fail(Status::unsupported,
             "{} is too large for the 32-bit numbers of a GLB file: write .bvh or .csv", value);
    return result;
}

std::vector<float> gltf_times(const std::vector<std::int64_t>& frames, double fps) {
    std::vector<float> times;
    for (const std::int64_t frame : frames) {
        const float time = narrow(static_cast<double>(frame) / fps);
        if (!times.empty() && !(time > times.back()))
            fail(Status::unsupported,
                 "the clip is too long for the 32-bit times of a GLB file, which are the same for "
                 "frame {} and the one before: write stretches of it",
                 frame);
        times.push_back(time);
    }
    return times;
}

int GltfBuffer::add(int components, const std::vector<float>& values) {
    constexpr int type_float = 5126; // glTF 2.0 specification, section 5.1.3
    const auto size = static_cast<std::size_t>(components);
    views_.push_back(JsonObject("buffer", 0, "byteOffset", static_cast<std::int64_t>(bytes_.size()),
                                "byteLength",
                                static_cast<std::int64_t>(values.size() * sizeof(float))));
    accessors_.push_back(JsonObject(
        "bufferView", static_cast<std::int64_t>(accessors_.size()), "componentType", type_float,
        "count", static_cast<std::int64_t>(values.size() / size), "type", type_of(components),
        "min", bound(size, values, std::less<>()), "max", bound(size, values, std::greater<>())));
    for (const float value : values)
        append_little_endian(bytes_, value);
    return static_cast<int>(accessors_.size()) - 1;
}

void GltfBuffer::describe(JsonObject& file) const {
    const JsonObject whole("byteLength", static_cast<std::int64_t>(bytes_.size()));
    file.set("buffers", std::vector<Json>{whole}, "bufferViews", views_, "accessors", accessors_);
}

} // namespace stltsa::clip
