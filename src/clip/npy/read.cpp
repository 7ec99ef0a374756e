// SPDX-License-Identifier: BSD-3-Clause
#include "base/checkpoint.hpp"
#include "clip/npy/header.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "base/npy_bytes.hpp"
#include "clip/arrays/missing_codes.hpp"
#include "clip/clip.hpp"
#include "clip/features/jump.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

struct Shape {
    std::int64_t rows = 1, cols = 1;
    int space = 0; ///< frames x points x 2 or 3
};

Shape checked_shape(const NpyHeader& header, std::size_t data_size, const std::string& name) {
    if (header.shape.empty())
        fail(Status::shape, "{}: the array is a single number; expected frames as rows", name);
    const std::size_t dimensions = header.shape.size();
    const bool points = dimensions == 3 && (header.shape[2] == 2 || header.shape[2] == 3);
    if (dimensions > 2 && !points)
        fail(Status::shape,
             "{}: the array has {} dimensions; expected frames, frames x columns, or frames x "
             "points x 2 or 3: save array.reshape(len(array), -1)",
             name, dimensions);
    Shape shape{header.shape[0], dimensions == 1 ? 1 : header.shape[1], 0};
    if (shape.rows == 0 || shape.cols == 0)
        fail(Status::shape, "{}: the array is empty", name);
    if (points) {
        shape.space = static_cast<int>(header.shape[2]);
        if (shape.cols > std::numeric_limits<std::int64_t>::max() / shape.space)
            fail(Status::format, "{}: the header declares {} points", name, shape.cols);
        shape.cols *= shape.space;
    }
    const auto items = static_cast<std::int64_t>(data_size / header.item_size);
    if (shape.rows > items / shape.cols)
        fail(Status::format,
             "{}: the header declares {} frames of {} numbers, but the data end after {}", name,
             shape.rows, shape.cols, items / shape.cols);
    if (data_size != header.item_size * static_cast<std::size_t>(shape.rows * shape.cols))
        fail(Status::format, "{}: there are more bytes than {} frames of {} numbers need", name,
             shape.rows, shape.cols);
    return shape;
}

template <class Number>
double load(const char* from, bool swap) {
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(from, bytes.size(), bytes.begin());
    if (swap)
        std::ranges::reverse(bytes);
    return static_cast<double>(std::bit_cast<Number>(bytes));
}

template <class One, class Two, class Four, class Eight>
double load_sized(const char* from, std::size_t size, bool swap) {
    return size == 1   ? load<One>(from, swap)
           : size == 2 ? load<Two>(from, swap)
           : size == 4 ? load<Four>(from, swap)
                       : load<Eight>(from, swap);
}

bool is_swapped(const NpyHeader& header) {
    return header.big_endian != (std::endian::native == std::endian::big);
}

double item(const NpyHeader& header, const char* data, std::int64_t index) {
    const bool swap = is_swapped(header);
    const char* from = data + static_cast<std::size_t>(index) * header.item_size;
    if (header.kind == 'i')
        return load_sized<std::int8_t, std::int16_t, std::int32_t, std::int64_t>(
            from, header.item_size, swap);
    if (header.kind == 'u')
        return load_sized<std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t>(
            from, header.item_size, swap);
    return header.item_size == 4 ? load<float>(from, swap) : load<double>(from, swap);
}

Matrix converted(const NpyHeader& header, const char* data, Shape shape) {
    Matrix values = Matrix::unset(shape.rows, shape.cols);
    const std::int64_t width = std::max(1, shape.space);
    // In Fortran order the point's coordinate changes slowest.
    const auto fortran = [&](std::int64_t i, std::int64_t c) {
        return ((c % width) * (shape.cols / width) + c / width) * shape.rows + i;
    };
    for (std::int64_t i = 0; i < shape.rows; ++i) {
        for (std::int64_t c = 0; c < shape.cols; ++c)
            values(i, c) =
                item(header, data, header.fortran_order ? fortran(i, c) : i * shape.cols + c);
        checkpoint(2 * shape.cols);
    }
    return values;
}

/// NaN is a missing value.
void check_finite(const Matrix& values, const std::string& name) {
    for (std::int64_t i = 0; i < values.rows(); ++i) {
        for (std::int64_t c = 0; c < values.cols(); ++c)
            if (std::isinf(values(i, c)))
                fail(Status::not_finite, "{}: frame {}, column {} is {}", name, i, c + 1,
                     values(i, c));
        checkpoint(values.cols());
    }
}

} // namespace

Clip parse_npy(std::string_view bytes, const std::string& name, const ReadOptions&) {
    const NpyHeader header = read_npy_header(bytes, name);
    const std::string_view data = bytes.substr(header.data_begin);
    const Shape shape = checked_shape(header, data.size(), name);
    Clip clip;
    clip.values = converted(header, data.data(), shape);
    clip.space = shape.space;
    check_finite(clip.values, name);
    drop_missing_codes(clip.values, {}, clip.notes);
    if (const std::int64_t jump = find_jump(clip.values.view(), std::max(1, clip.space)); jump > 0)
        clip.notes.push_back(format_text(
            "the numbers jump at frame {}: if frames were lost there, insert them as NaN, or save "
            "points with their times in another format; if they are angles, unwrap them",
            jump));
    return clip;
}

std::string format_npy(const Clip& clip) {
    return npy_bytes(clip.values.data(), clip.values.rows(), clip.values.cols(), clip.space);
}

} // namespace stltsa::clip
