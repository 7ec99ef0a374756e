// SPDX-License-Identifier: BSD-3-Clause
#include "capi/arrays.hpp"

#include <cstring>
#include <limits>

#include "capi/guard.hpp"

namespace stltsa::capi {
namespace {

std::int64_t entry_size(std::int32_t dtype, const char* name) {
    if (dtype == STLTSA_F32)
        return sizeof(float);
    if (dtype == STLTSA_F64)
        return sizeof(double);
    fail(Status::argument, "{}: dtype is {}; STLTSA_F32 ({}) or STLTSA_F64 ({}) is needed", name,
         dtype, static_cast<int>(STLTSA_F32), static_cast<int>(STLTSA_F64));
}

struct Strides {
    std::int64_t row, col;
};

/// Where each entry of a row, or column, is to have a place of its own.
void check_step(const char* name, const char* which, std::int64_t count, std::int64_t stride,
                std::int64_t size) {
    if (count > 1 && stride < size && stride > -size)
        fail(Status::shape,
             "{}: {} is {}, and entries have {} bytes: what is written would overlap", name, which,
             stride, size);
}

/// The checks that both directions share; returns the strides in bytes.
template <class Array>
Strides check_array(const Array* array, const char* name) {
    const Array& a = required(array, name);
    const std::int64_t size = entry_size(a.dtype, name);
    if (a.reserved != 0)
        fail(Status::argument, "{}: reserved is {}; it must be 0", name, a.reserved);
    if (a.rows < 0 || a.cols < 0)
        fail(Status::shape, "{}: {} x {} has a negative side", name, a.rows, a.cols);
    checked_size(a.rows, a.cols);
    if (a.rows > 0 && a.cols > 0 && a.data == nullptr)
        fail(Status::argument, "{}: data is NULL", name);
    if (a.row_stride == 0 && a.col_stride == 0)
        return {a.cols * size, size};
    return {a.row_stride, a.col_stride};
}

/// Entries need not be aligned.
double load(const char* at, std::int32_t dtype) {
    if (dtype == STLTSA_F32) {
        float value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }
    double value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

void store(char* at, std::int32_t dtype, double value) {
    if (dtype == STLTSA_F32) {
        const float narrow = static_cast<float>(value);
        std::memcpy(at, &narrow, sizeof narrow);
    } else {
        std::memcpy(at, &value, sizeof value);
    }
}

bool is_packed_double(const stltsa_in& in, Strides strides) {
    const auto row = static_cast<std::int64_t>(sizeof(double)) * in.cols;
    return in.dtype == STLTSA_F64 && strides.col == static_cast<std::int64_t>(sizeof(double)) &&
           strides.row == row && reinterpret_cast<std::uintptr_t>(in.data) % alignof(double) == 0;
}

} // namespace

InputFrames::InputFrames(const stltsa_in* in, const char* name) {
    const Strides strides = check_array(in, name);
    if (is_packed_double(*in, strides)) {
        view_ = {static_cast<const double*>(in->data), in->rows, in->cols, in->cols};
        return;
    }
    copy_ = Matrix(in->rows, in->cols);
    const char* bytes = static_cast<const char*>(in->data);
    for (std::int64_t r = 0; r < in->rows; ++r)
        for (std::int64_t c = 0; c < in->cols; ++c)
            copy_(r, c) = load(bytes + r * strides.row + c * strides.col, in->dtype);
    view_ = static_cast<const Matrix&>(copy_).view();
}

void check_output(const stltsa_out* out, const char* name, std::int64_t rows, std::int64_t cols) {
    const Strides strides = check_array(out, name);
    check_step(name, "row_stride", out->rows, strides.row, entry_size(out->dtype, name));
    check_step(name, "col_stride", out->cols, strides.col, entry_size(out->dtype, name));
    if (out->rows != rows || out->cols != cols)
        fail(Status::shape, "{}: the array is {} x {}; {} x {} is needed", name, out->rows,
             out->cols, rows, cols);
}

void write_output(const stltsa_out* out, const char* name, ConstMatrixView values) {
    check_output(out, name, values.rows, values.cols);
    const Strides strides = check_array(out, name);
    char* bytes = static_cast<char*>(out->data);
    for (std::int64_t r = 0; r < values.rows; ++r)
        for (std::int64_t c = 0; c < values.cols; ++c)
            store(bytes + r * strides.row + c * strides.col, out->dtype, values(r, c));
}

void write_column(const stltsa_out* out, const char* name, const std::vector<double>& values) {
    write_output(out, name, {values.data(), static_cast<std::int64_t>(values.size()), 1, 1});
}

std::vector<std::int64_t> clip_lengths(const std::int64_t* lengths, std::int64_t clips,
                                       std::int64_t rows) {
    if (lengths == nullptr) {
        if (clips > 1)
            fail(Status::argument, "lengths is NULL and clips is {}; give the clips' lengths",
                 clips);
        return {rows};
    }
    if (clips < 1 || clips > rows)
        fail(Status::shape, "clips is {}; there are {} frames", clips, rows);
    return {lengths, lengths + clips};
}

} // namespace stltsa::capi
