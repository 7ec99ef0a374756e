// SPDX-License-Identifier: BSD-3-Clause
#include "exit_status.hpp"

#include "arguments/option_flags.hpp"
#include "terminal/text.hpp"

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
    case STLTSA_E_NO_SUCH_PART:
        return Exit::untrustworthy;
    case STLTSA_E_CANCELLED:
        return Exit::interrupted;
    default:
        return Exit::failed;
    }
}

bool is_input_to_blame(stltsa_status status) {
    return status != STLTSA_E_ARGUMENT && status != STLTSA_E_NO_SUCH_PART &&
           status != STLTSA_E_CANCELLED && status != STLTSA_E_NO_MEMORY &&
           status != STLTSA_E_INTERNAL;
}

std::string text_of(const stltsa::Error& error) {
    return error.status() == STLTSA_E_CANCELLED ? "cancelled" : one_line(with_flags(error.what()));
}

} // namespace

Failure::Failure(const stltsa::Error& error)
    : status_(exit_of(error.status())), text_(text_of(error)) {}

Failure unreadable(const stltsa::Error& error) {
    return is_input_to_blame(error.status()) ? Failure(Exit::unreadable, text_of(error))
                                             : Failure(error);
}

} // namespace tool
