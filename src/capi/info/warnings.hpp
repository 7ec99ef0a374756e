// SPDX-License-Identifier: BSD-3-Clause
// Warnings as rows, of whatever handle `warnings_of` knows those of.
#pragma once

#include "base/warning.hpp"
#include "capi/info/info.hpp"

namespace stltsa::capi {

template <class H, class Get>
constexpr InfoRow warning_row(Get) {
    return rows<H>(
        STLTSA_INFO_WARNING, [](const H& h) { return Get{}(h).size(); },
        [](const H& h, std::size_t index) {
            const Warning& found = Get{}(h)[index];
            return stltsa_warning{static_cast<std::int64_t>(found.code), found.text.c_str(),
                                  found.begin_s, found.end_s};
        });
}

} // namespace stltsa::capi
