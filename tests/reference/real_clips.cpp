// SPDX-License-Identifier: BSD-3-Clause
#include "real_clips.hpp"

#include <algorithm>
#include <filesystem>

#include "fitted.hpp"

namespace reference {
namespace {

/// `next` after `chain`: over the last second of the one and the first of the other the weights
/// move smoothly, so that neighborhoods connect across the joint.
Frames cross_faded(const Frames& chain, const Frames& next) {
    constexpr std::size_t overlap = 120;
    const std::size_t begin = chain.rows - overlap;
    Frames result(begin + next.rows, chain.cols);
    std::copy(chain.values.begin(), chain.values.end(), result.values.begin());
    std::copy(next.row(overlap), next.row(0) + next.values.size(), result.row(chain.rows));
    for (std::size_t i = 0; i < overlap; ++i) {
        const double t = static_cast<double>(i + 1) / static_cast<double>(overlap + 1);
        const double weight = t * t * (3 - 2 * t);
        for (std::size_t c = 0; c < chain.cols; ++c)
            result(begin + i, c) = (1 - weight) * chain(begin + i, c) + weight * next(i, c);
    }
    return result;
}

Frames first_frames(const Frames& frames, std::size_t count) {
    Frames result(std::min(count, frames.rows), frames.cols);
    std::copy_n(frames.values.begin(), result.values.size(), result.values.begin());
    return result;
}

} // namespace

bool has_real_clips(const std::string& folder) {
    return std::filesystem::exists(folder + "/cmu/86_01.amc");
}

Frames real_chain(const std::string& folder, std::size_t count) {
    const std::string cmu = folder + "/cmu/";
    const std::string skeleton = cmu + "86.asf"; // 13.asf is not published with these clips
    Frames chain = euler_features(cmu + "13_29.amc", skeleton);
    for (const char* file : {"13_30.amc", "86_01.amc"})
        chain = cross_faded(chain, euler_features(cmu + file, skeleton));
    return first_frames(chain, count);
}

} // namespace reference
