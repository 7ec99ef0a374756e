// SPDX-License-Identifier: BSD-3-Clause
#include "library.hpp"

#include "exit_status.hpp"
#include "option_flags.hpp"

namespace tool {
namespace {

Exit exit_of(stltsa_status status) {
    switch (status) {
    case STLTSA_E_ARGUMENT:
        return Exit::usage;
    case STLTSA_E_IO:
    case STLTSA_E_FORMAT:
    case STLTSA_E_NOT_FINITE:
        return Exit::unreadable;
    case STLTSA_E_TOO_FEW_FRAMES:
    case STLTSA_E_DISCONNECTED:
    case STLTSA_E_DEGENERATE:
    case STLTSA_E_NO_COMMON_POSTURE:
        return Exit::untrustworthy;
    case STLTSA_E_CANCELLED:
        return Exit::interrupted;
    default:
        return Exit::failed;
    }
}

[[noreturn]] void fail_with(stltsa_status status, Exit exit) {
    throw Failure(exit,
                  status == STLTSA_E_CANCELLED ? "cancelled" : with_flags(stltsa_last_error()));
}

} // namespace

void check(stltsa_status status) {
    if (status != STLTSA_OK)
        fail_with(status, exit_of(status));
}

void check_reading(stltsa_status status) {
    switch (status) {
    case STLTSA_OK:
        return;
    case STLTSA_E_ARGUMENT:
    case STLTSA_E_CANCELLED:
    case STLTSA_E_NO_MEMORY:
    case STLTSA_E_INTERNAL:
        fail_with(status, exit_of(status));
    default:
        fail_with(status, Exit::unreadable);
    }
}

Json parsed_json(const char* text) {
    return Json::parse(text);
}

stltsa_out out_of(Grid& grid) {
    return {grid.values.data(), grid.rows, grid.cols, 0, 0, STLTSA_F64, 0};
}

Grid coordinates_of(const stltsa_model* model) {
    std::int64_t rows = 0;
    std::int64_t cols = 0;
    check(stltsa_model_get_int(model, STLTSA_MODEL_FRAMES, &rows));
    check(stltsa_model_get_int(model, STLTSA_MODEL_DIMENSION, &cols));
    return grid_of(stltsa_model_coords, model, rows, cols);
}

} // namespace tool
