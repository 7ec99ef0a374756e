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
template <class Number, class Better>
std::vector<double> bound(std::size_t components, const std::vector<Number>& values,
                          Better better) {
    std::vector<double> best(values.begin(),
                             values.begin() + static_cast<std::ptrdiff_t>(components));
    for (std::size_t i = components; i < values.size(); ++i)
        best[i % components] =
            std::min(best[i % components], static_cast<double>(values[i]), better);
    return best;
}

void append_little_endian(std::string& bytes, std::uint16_t value) {
    bytes += static_cast<char>(value & 0xff);
    bytes += static_cast<char>(value >> 8);
}

void append_little_endian(std::string& bytes, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    append_little_endian(bytes, static_cast<std::uint16_t>(bits & 0xffff));
    append_little_endian(bytes, static_cast<std::uint16_t>(bits >> 16));
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

template <class Number>
int GltfBuffer::append(int component_type, int components, const std::vector<Number>& values,
                       BufferUse use) {
    const auto size = static_cast<std::size_t>(components);
    JsonObject view("buffer", 0, "byteOffset", static_cast<std::int64_t>(bytes_.size()),
                    "byteLength", static_cast<std::int64_t>(values.size() * sizeof(Number)));
    if (use != BufferUse::numbers)
        view.set("target", static_cast<int>(use));
    views_.push_back(view);
    accessors_.push_back(JsonObject(
        "bufferView", static_cast<std::int64_t>(accessors_.size()), "componentType", component_type,
        "count", static_cast<std::int64_t>(values.size() / size), "type", type_of(components),
        "min", bound(size, values, std::less<>()), "max", bound(size, values, std::greater<>())));
    for (const Number value : values)
        append_little_endian(bytes_, value);
    return static_cast<int>(accessors_.size()) - 1;
}

int GltfBuffer::add(int components, const std::vector<float>& values, BufferUse use) {
    return append(5126, components, values, use);
}

int GltfBuffer::add(int components, const std::vector<std::uint16_t>& values, BufferUse use) {
    return append(5123, components, values, use);
}

void GltfBuffer::describe(JsonObject& file) const {
    const JsonObject whole("byteLength", static_cast<std::int64_t>(bytes_.size()));
    file.set("buffers", std::vector<Json>{whole}, "bufferViews", views_, "accessors", accessors_);
}

} // namespace stltsa::clip
