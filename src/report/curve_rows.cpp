// SPDX-License-Identifier: BSD-3-Clause
#include "report/curve_rows.hpp"

#include <algorithm>

#include "base/numbers.hpp"

namespace stltsa::report {

Matrix curve_rows(const results::Decomposed& decomposed, std::int64_t step) {
    const motion::Curve& found = decomposed.curve;
    const auto count = static_cast<std::int64_t>(found.curve.size());
    Matrix rows((count + step - 1) / step, 3);
    for (std::int64_t r = 0; r < rows.rows(); ++r) {
        rows(r, 0) = found.curve[static_cast<std::size_t>(r * step)];
        for (int c = 0; c < 2; ++c)
            rows(r, 1 + c) = found.coords(r * step, c);
        if (std::all_of(rows.row(r), rows.row(r) + 3, [](double value) { return value == 0; }))
            std::fill_n(rows.row(r), 3, none);
    }
    return rows;
}

} // namespace stltsa::report
