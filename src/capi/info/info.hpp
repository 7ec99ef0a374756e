// SPDX-License-Identifier: BSD-3-Clause
// Facts of handles by key: stltsa_info_int() and similar functions look them up in a table for each
// kind of handle.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

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

struct InfoRow {
    std::int32_t key = 0;
    bool is_list = false;
    std::int64_t (*count)(const stltsa_info&) = nullptr;
    Fact (*value)(const stltsa_info&, std::size_t index) = nullptr;
};

struct InfoTable {
    std::int32_t handle; ///< STLTSA_HANDLE_*
    std::span<const InfoRow> own;
    std::span<const InfoRow> source; ///< where its rows come from
    std::span<const InfoRow> fit;    ///< parameters
    std::span<const InfoRow> warnings;
};

extern const InfoTable clip_table, model_table, dimension_table, decomposition_table,
    denoising_table, synthesis_table;

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

} // namespace stltsa::capi
