// SPDX-License-Identifier: BSD-3-Clause
// libstltsa with owners for its handles and Failure for its statuses.
#pragma once

#include <memory>
#include <string>

#include <nlohmann/json.hpp>
#include <stltsa.h>

#include "grid.hpp"

namespace tool {

template <auto free_handle>
struct FreeHandle {
    template <class T>
    void operator()(T* handle) const {
        free_handle(handle);
    }
};
using Options = std::unique_ptr<stltsa_options, FreeHandle<stltsa_options_free>>;
using Clip = std::unique_ptr<stltsa_clip, FreeHandle<stltsa_clip_free>>;
using Model = std::unique_ptr<stltsa_model, FreeHandle<stltsa_model_free>>;
using Dimension = std::unique_ptr<stltsa_dimension_result, FreeHandle<stltsa_dimension_free>>;
using Denoising = std::unique_ptr<stltsa_denoising, FreeHandle<stltsa_denoising_free>>;
using Synthesis = std::unique_ptr<stltsa_synthesis, FreeHandle<stltsa_synthesis_free>>;
using Decomposition = std::unique_ptr<stltsa_decomposition, FreeHandle<stltsa_decomposition_free>>;

using Json = nlohmann::ordered_json;

/// Throws the library's last error as a Failure unless the status is OK.
void check(stltsa_status status);
/// The same for calls that read the input: whatever is wrong with it makes it unreadable.
void check_reading(stltsa_status status);

/// Calls library function `make(..., T** handle)` and owns what it makes.
template <class Handle, class Function>
Handle made_by(Function make) {
    typename Handle::pointer handle = nullptr;
    check(make(&handle));
    return Handle(handle);
}

/// Compiled once: in every file that asks for an object it would be half of what that takes.
Json parsed_json(const char* text);

/// The object that a library function `(handle, char** json)` writes.
template <class Handle>
Json json_of(stltsa_status (*write)(const Handle*, char**) noexcept, const Handle* handle) {
    char* text = nullptr;
    check(write(handle, &text));
    const std::unique_ptr<char, FreeHandle<stltsa_string_free>> owner(text);
    return parsed_json(text);
}

stltsa_out out_of(Grid& grid);

/// The table that a library function `(handle, const stltsa_out*)` fills.
template <class Handle>
Grid grid_of(stltsa_status (*fill)(const Handle*, const stltsa_out*) noexcept, const Handle* handle,
             std::int64_t rows, std::int64_t cols) {
    Grid grid(rows, cols);
    const stltsa_out out = out_of(grid);
    check(fill(handle, &out));
    return grid;
}

/// rows x d.
Grid coordinates_of(const stltsa_model* model);

} // namespace tool
