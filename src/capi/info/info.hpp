// SPDX-License-Identifier: BSD-3-Clause
// Facts of handles by key: stltsa_info_int() and similar functions look them up in a table for each
// kind of handle.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "linalg/matrix.hpp"
#include "stltsa.h"

namespace stltsa::capi {

struct InfoTable;

} // namespace stltsa::capi

/// The base of every handle that has facts.
struct stltsa_info {
    const stltsa::capi::InfoTable* table;
};

namespace stltsa::capi {

using Fact = std::variant<std::int64_t, double, const char*>;

struct Shape {
    std::int64_t rows = 0, cols = 0;
};

/// A fact, a list of rows, or arrays.
struct InfoRow {
    std::int32_t key = 0;
    bool is_list = false;
    std::int64_t (*count)(const stltsa_info&) = nullptr;
    Fact (*value)(const stltsa_info&, std::size_t index) = nullptr;
    /// Fills so many bytes of the caller's struct.
    void (*row)(const stltsa_info&, std::size_t index, void* to, std::size_t size) = nullptr;
    Shape (*shape)(const stltsa_info&) = nullptr;
    void (*write)(const stltsa_info&, std::size_t index, const stltsa_out* to) = nullptr;
};

struct InfoTable {
    std::int32_t handle; ///< STLTSA_HANDLE_*
    std::string (*json)(const stltsa_info&);
    std::span<const InfoRow> own;
    std::span<const InfoRow> source; ///< where its rows come from
    std::span<const InfoRow> fit;    ///< parameters
    std::span<const InfoRow> warnings;
};

extern const InfoTable clip_table, model_table, decomposition_table, phase_table, cycles_table,
    events_table, comparison_table, live_table, denoising_table, synthesis_table;

/// The tables of all kinds of handles.
std::span<const InfoTable* const> info_tables();

/// All keys in order, without `is_list` and `handles`, which follow from the tables above; `size`
/// is left 0.
std::span<const stltsa_info_key> info_keys();

/// The handle that an info is the base of.
template <class Handle>
const Handle& handle_of(const stltsa_info& info) {
    return static_cast<const Handle&>(info);
}

inline Fact fact(double value) {
    return value;
}
inline Fact fact(const std::string& value) {
    return value.c_str();
}
Fact fact(std::string&&) = delete; // would be gone before it is read
template <class T>
requires std::is_integral_v<T> || std::is_enum_v<T> Fact fact(T value) {
    return static_cast<std::int64_t>(value);
}

/// A fact with one value. `Get`: a lambda without captures from the handle to the value.
template <class Handle, class Get>
constexpr InfoRow one(std::int32_t key, Get) {
    return {
        key, false, [](const stltsa_info&) { return std::int64_t{1}; },
        [](const stltsa_info& info, std::size_t) { return fact(Get{}(handle_of<Handle>(info))); }};
}

/// A fact of an optional part of the handle: `Find` returns a pointer to the part, or null.
template <class Handle, class Find, class Get>
constexpr InfoRow maybe(std::int32_t key, Find, Get) {
    return {key, false,
            [](const stltsa_info& info) {
                return std::int64_t{Find{}(handle_of<Handle>(info)) != nullptr};
            },
            [](const stltsa_info& info, std::size_t) {
                return fact(Get{}(*Find{}(handle_of<Handle>(info))));
            }};
}

/// An option that the handle has if it was set. `Get` gives the std::optional in the handle.
template <class Handle, class Get>
constexpr InfoRow set(std::int32_t key, Get) {
    return maybe<Handle>(
        key, [](const Handle& h) { return Get{}(h) ? &*Get{}(h) : nullptr; },
        [](const auto& value) { return value; });
}

/// A fact of each element of the vector that `List` returns.
template <class Handle, class List, class Get>
constexpr InfoRow each(std::int32_t key, List, Get) {
    return {key, true,
            [](const stltsa_info& info) {
                return static_cast<std::int64_t>(List{}(handle_of<Handle>(info)).size());
            },
            [](const stltsa_info& info, std::size_t index) {
                return fact(Get{}(List{}(handle_of<Handle>(info))[index]));
            }};
}

template <class Handle, class List>
constexpr InfoRow list(std::int32_t key, List of) {
    return each<Handle>(
        key, of, [](const auto& value) -> const auto& { return value; });
}

/// A list of structs. `Count` gives their number, `Make` the one with an index, both of the handle.
template <class Handle, class Count, class Make>
constexpr InfoRow rows(std::int32_t key, Count, Make) {
    InfoRow row{key, true, [](const stltsa_info& info) {
                    return static_cast<std::int64_t>(Count{}(handle_of<Handle>(info)));
                }};
    row.row = [](const stltsa_info& info, std::size_t index, void* to, std::size_t size) {
        const auto made = Make{}(handle_of<Handle>(info), index);
        const std::size_t known = std::min(size, sizeof made);
        std::memcpy(to, &made, known);
        std::memset(static_cast<char*>(to) + known, 0, size - known);
    };
    return row;
}

/// The structs of the vector that `List` returns.
template <class Handle, class List>
constexpr InfoRow rows(std::int32_t key, List) {
    return rows<Handle>(
        key, [](const Handle& h) { return List{}(h).size(); },
        [](const Handle& h, std::size_t index) { return List{}(h)[index]; });
}

inline Shape shape_of(const Matrix& values) {
    return {values.rows(), values.cols()};
}
template <class Column>
Shape shape_of(const Column& column) {
    return {static_cast<std::int64_t>(column.size()), 1};
}

/// Arrays. `Count` gives their number, `Of` the shape of all of them, `Get` the one with an index.
template <class Handle, class Count, class Of, class Get>
constexpr InfoRow arrays(std::int32_t key, bool several, Count, Of, Get) {
    InfoRow row{key, several, [](const stltsa_info& info) {
                    return static_cast<std::int64_t>(Count{}(handle_of<Handle>(info)));
                }};
    row.shape = [](const stltsa_info& info) { return Of{}(handle_of<Handle>(info)); };
    row.write = [](const stltsa_info& info, std::size_t index, const stltsa_out* to) {
        const Handle& handle = handle_of<Handle>(info);
        const Shape shape = Of{}(handle);
        if (required(to, "array").dtype != STLTSA_I64)
            check_output(to, "array", shape.rows, shape.cols); // before it is computed
        write_array(to, Get{}(handle, index));
    };
    return row;
}

/// The matrix or column that `Get` returns.
template <class Handle, class Get>
constexpr InfoRow array(std::int32_t key, Get) {
    return arrays<Handle>(
        key, false, [](const Handle&) { return 1; },
        [](const Handle& h) { return shape_of(Get{}(h)); },
        [](const Handle& h, std::size_t) -> const auto& { return Get{}(h); });
}

} // namespace stltsa::capi
