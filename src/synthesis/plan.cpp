// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/plan.hpp"

namespace stltsa::synthesis {

std::vector<Run> make_runs(std::span<const Part> parts) {
    std::vector<Run> runs;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const Part& part = parts[p];
        const auto piece = static_cast<std::int64_t>(p);
        for (std::int64_t r = 0; r < part.repeat; ++r) {
            if (!runs.empty() && runs.back().track == part.track && runs.back().end == part.begin) {
                runs.back().end = part.end;
                runs.back().last_piece = piece;
            } else {
                runs.push_back({part.track, part.begin, part.end, piece, piece});
            }
        }
    }
    return runs;
}

} // namespace stltsa::synthesis
