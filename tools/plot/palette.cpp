// SPDX-License-Identifier: BSD-3-Clause
#include "plot/palette.hpp"

#include <stltsa.hpp>

namespace tool::plot {

UnitColors unit_colors(std::int32_t kind) {
    switch (kind) {
    case STLTSA_UNIT_PREPARING:
        return {"#56b4e9", "#e9f5fc", ink};
    case STLTSA_UNIT_INITIAL:
        return {"#e69f00", "#fcf1dc", ink};
    case STLTSA_UNIT_CYCLIC:
        return {"#0072b2", "#e0eef6", "#ffffff"};
    case STLTSA_UNIT_FINAL:
        return {"#d55e00", "#fae9de", "#ffffff"};
    case STLTSA_UNIT_WIND_UP:
        return {"#cc79a7", "#f9eef4", ink};
    case STLTSA_UNIT_ACTION:
        return {"#009e73", "#def2ec", "#ffffff"};
    default:
        return {"#0072b2", "#ffffff", "#ffffff"};
    }
}

} // namespace tool::plot
