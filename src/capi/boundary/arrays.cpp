// SPDX-License-Identifier: BSD-3-Clause
#include "capi/boundary/arrays.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "capi/boundary/guard.hpp"

namespace stltsa::capi {
namespace {

enum class Entries { numbers, integers };

std::int64_t entry_size(std::int32_t dtype, const char* name, Entries entries) {
    if (entries == Entries::integers && dtype != STLTSA_I64)
        fail(Status::argument, "{}: dtype is {}; STLTSA_I64 ({}) is needed", name, dtype,
             static_cast<int>(STLTSA_I64));
    if (entries == Entries::numbers && dtype != STLTSA_F32 && dtype != STLTSA_F64)
        fail(Status::argument, "{}: dtype is {}; STLTSA_F32 ({}) or STLTSA_F64 ({}) is needed",
             name, dtype, static_cast<int>(STLTSA_F32), static_cast<int>(STLTSA_F64));
    return dtype == STLTSA_F32 ? 4 : 8;
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

/// Checks that inputs and outputs share; returns the strides in bytes.
template <class Array>
Strides check_array(const Array* array, const char* name, Entries entries) {
    const Array& a = required(array, name);
    const std::int64_t size = entry_size(a.dtype, name, entries);
    if (a.reserved != 0)
        fail(Status::argument, "{}: reserved is {}; it must be 0", name, a.reserved);
    if (a.rows < 0 || a.cols < 0)
        fail(Status::shape, "{}: {} x {} has a negative side", name, a.rows, a.cols);
    checked_size(a.rows, a.cols);
    if (a.rows > 0 && a.cols > 0 && a.data == nullptr)
        fail(Status::argument, "{}: data is NULL", name);
    if (a.row_stride == 0 && a.col_stride == 0)
        return {a.cols * size, size};
    const auto reach = [](std::int64_t count, std::int64_t stride) {
        return static_cast<double>(count) * std::abs(static_cast<double>(stride));
    };
    constexpr double most = 0x1p62; // bytes
    if (reach(a.rows, a.row_stride) + reach(a.cols, a.col_stride) > most)
        fail(Status::shape, "{}: {} x {} entries with strides {} and {} do not fit into memory",
             name, a.rows, a.cols, a.row_stride, a.col_stride);
    return {a.row_stride, a.col_stride};
}

/// Entries need not be aligned.
template <class Entry>
Entry load(const char* at) {
    Entry value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <class Entry>
void store(char* at, Entry value) {
    std::memcpy(at, &value, sizeof value);
}

Strides check_output(const stltsa_out* out, const char* name, std::int64_t rows, std::int64_t cols,
                     Entries entries) {
    const Strides strides = check_array(out, name, entries);
    const std::int64_t size = entry_size(out->dtype, name, entries);
    check_step(name, "row_stride", out->rows, strides.row, size);
    check_step(name, "col_stride", out->cols, strides.col, size);
    if (out->rows != rows || out->cols != cols)
        fail(Status::shape, "{}: the array is {} x {}; {} x {} is needed", name, out->rows,
             out->cols, rows, cols);
    return strides;
}

bool is_packed_double(const stltsa_in& in, Strides strides) {
    const auto row = static_cast<std::int64_t>(sizeof(double)) * in.cols;
    return in.dtype == STLTSA_F64 && strides.col == static_cast<std::int64_t>(sizeof(double)) &&
           strides.row == row && reinterpret_cast<std::uintptr_t>(in.data) % alignof(double) == 0;
}

} // namespace

InputFrames::InputFrames(const stltsa_in* in, const char* name) {
    const Strides strides = check_array(in, name, Entries::numbers);
    if (is_packed_double(*in, strides)) {
        view_ = {static_cast<const double*>(in->data), in->rows, in->cols, in->cols};
        return;
    }
    copy_ = Matrix(in->rows, in->cols);
    const char* bytes = static_cast<const char*>(in->data);
    for (std::int64_t r = 0; r < in->rows; ++r)
        for (std::int64_t c = 0; c < in->cols; ++c) {
            const char* at = bytes + r * strides.row + c * strides.col;
            copy_(r, c) = in->dtype == STLTSA_F32 ? load<float>(at) : load<double>(at);
        }
    view_ = static_cast<const Matrix&>(copy_).view();
}

std::vector<std::int64_t> input_integers(const stltsa_in* in, const char* name) {
    const Strides strides = check_array(in, name, Entries::integers);
    if (in->cols != 1)
        fail(Status::shape, "{}: the array is {} x {}; it must have one column", name, in->rows,
             in->cols);
    std::vector<std::int64_t> values;
    const char* bytes = static_cast<const char*>(in->data);
    for (std::int64_t r = 0; r < in->rows; ++r)
        values.push_back(load<std::int64_t>(bytes + r * strides.row));
    return values;
}

void check_output(const stltsa_out* out, const char* name, std::int64_t rows, std::int64_t cols) {
    check_output(out, name, rows, cols, Entries::numbers);
}

void check_integers(const stltsa_out* out, const char* name, std::int64_t rows) {
    check_output(out, name, rows, 1, Entries::integers);
}

void write_output(const stltsa_out* out, const char* name, ConstMatrixView values) {
    const Strides strides = check_output(out, name, values.rows, values.cols, Entries::numbers);
    char* bytes = static_cast<char*>(out->data);
    for (std::int64_t r = 0; r < values.rows; ++r)
        for (std::int64_t c = 0; c < values.cols; ++c) {
            char* at = bytes + r * strides.row + c * strides.col;
            if (out->dtype == STLTSA_F32)
                store(at, static_cast<float>(values(r, c)));
            else
                store(at, values(r, c));
        }
}

void write_column(const stltsa_out* out, const char* name, const std::vector<double>& values) {
    write_output(out, name, {values.data(), static_cast<std::int64_t>(values.size()), 1, 1});
}

void write_integers(const stltsa_out* out, const char* name, std::span<const std::int64_t> values) {
    const auto rows = static_cast<std::int64_t>(values.size());
    const Strides strides = check_output(out, name, rows, 1, Entries::integers);
    char* at = static_cast<char*>(out->data);
    for (std::int64_t r = 0; r < rows; ++r)
        store(at + r * strides.row, values[static_cast<std::size_t>(r)]);
}

void write_array(const stltsa_out* out, const Matrix& values) {
    write_output(out, "array", values.view());
}

void write_array(const stltsa_out* out, std::span<const double> column) {
    write_output(out, "array", {column.data(), std::ssize(column), 1, 1});
}

void write_array(const stltsa_out* out, std::span<const std::int64_t> column) {
    if (required(out, "array").dtype == STLTSA_I64)
        write_integers(out, "array", column);
    else
        write_array(out, std::vector<double>(column.begin(), column.end()));
}

std::vector<std::int64_t> clip_lengths(const stltsa_in* lengths, std::int64_t rows) {
    if (lengths == nullptr)
        return {rows};
    if (lengths->rows < 1 || lengths->rows > rows)
        fail(Status::shape, "lengths has {} rows; there are {} frames", lengths->rows, rows);
    return input_integers(lengths, "lengths");
}

void check_samples(std::int64_t samples, std::int64_t least, std::int64_t most) {
    if (samples < least || samples > most)
        fail(Status::argument, "samples is {}; it must be {} to {}", samples, least, most);
}

} // namespace stltsa::capi
