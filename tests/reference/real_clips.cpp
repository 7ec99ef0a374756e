// SPDX-License-Identifier: BSD-3-Clause
#include "real_clips.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "fitted.hpp"

namespace reference {
namespace {

constexpr std::size_t joint = 120; ///< frames of a cross-fade

/// Appends `next` to `chain`: the weights move smoothly over the last second of one and the first
/// second of the other, so that neighborhoods connect across the joint.
void append(Frames& chain, const Frames& next) {
    const std::size_t begin = chain.rows - joint;
    for (std::size_t i = 0; i < joint; ++i) {
        const double t = static_cast<double>(i + 1) / static_cast<double>(joint + 1);
        const double weight = t * t * (3 - 2 * t);
        for (std::size_t c = 0; c < chain.cols; ++c)
            chain(begin + i, c) = (1 - weight) * chain(begin + i, c) + weight * next(i, c);
    }
    chain.values.insert(chain.values.end(), next.row(joint), next.row(0) + next.values.size());
    chain.rows = begin + next.rows;
}

} // namespace

bool has_real_clips(const std::string& folder) {
    return std::filesystem::exists(folder + "/cmu/86_01.amc");
}

Frames real_chain(const std::string& folder, std::size_t count) {
    const std::string cmu = folder + "/cmu/";
    const std::string skeleton = cmu + "86.asf"; // 13.asf is not published with these clips
    std::vector<Frames> clips;
    for (const char* file : {"13_29.amc", "13_30.amc", "86_01.amc"})
        clips.push_back(euler_features(cmu + file, skeleton));
    Frames chain = clips[0];
    chain.values.reserve((count + clips[0].rows + clips[1].rows + clips[2].rows) * chain.cols);
    for (std::size_t next = 1; chain.rows < count + joint; ++next)
        append(chain, clips[next % clips.size()]);
    chain.rows = count;
    chain.values.resize(count * chain.cols);
    return chain;
}

} // namespace reference
