// SPDX-License-Identifier: BSD-3-Clause
// Structs that grow: the caller says in `size` how much of them it knows.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "capi/boundary/guard.hpp"

namespace stltsa::capi {

/// A copy of a text that the caller frees with stltsa_free.
inline char* caller_string(const std::string& text) {
    char* copy = new char[text.size() + 1];
    std::memcpy(copy, text.c_str(), text.size() + 1);
    return copy;
}

/// What a caller must know at least: the size and the first field.
inline void check_size(std::size_t size, const char* name, const char* type) {
    if (size < sizeof(std::size_t) + sizeof(std::int64_t))
        fail(Status::argument, "{}->size is {}; set it to sizeof({})", name, size, type);
}

/// Fills the fields that the caller knows.
template <class Struct>
void give(Struct from, Struct* to, const char* name, const char* type) {
    const std::size_t size = required(to, name).size;
    check_size(size, name, type);
    from.size = size;
    std::memcpy(to, &from, std::min(size, sizeof from));
}

/// The caller's struct; fields that it does not know are 0.
template <class Struct>
Struct taken(const Struct* from, const char* name, const char* type) {
    const std::size_t size = required(from, name).size;
    check_size(size, name, type);
    Struct to{};
    std::memcpy(&to, from, std::min(size, sizeof to));
    return to;
}

} // namespace stltsa::capi
