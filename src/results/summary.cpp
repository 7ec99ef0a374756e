// SPDX-License-Identifier: BSD-3-Clause
#include "results/summary.hpp"

#include <cmath>
#include <map>

namespace stltsa::results {
namespace {

constexpr double minute = 60;

/// Lengths and middles of the parts of one label, in seconds.
struct Lengths {
    std::vector<double> length, middle;
    double covered = 0; ///< seconds from the first begin to the last end in each segment

    void add(const stltsa_part& part) {
        length.push_back(part.end_s - part.begin_s);
        middle.push_back((part.begin_s + part.end_s) / 2);
    }
};

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

stltsa_summary summary_of(int32_t label, const Lengths& all) {
    stltsa_summary summary{};
    summary.label = label;
    summary.count = static_cast<int64_t>(all.length.size());
    summary.mean_s = mean_of(all.length);
    summary.per_minute = minute * static_cast<double>(summary.count) / all.covered;
    if (summary.count < 2)
        return summary;
    const double center = mean_of(all.middle);
    double squares = 0, slope = 0, spread = 0;
    for (std::size_t i = 0; i < all.length.size(); ++i) {
        const double apart = all.length[i] - summary.mean_s, at = all.middle[i] - center;
        squares += apart * apart;
        slope += apart * at;
        spread += at * at;
    }
    summary.sd_s = std::sqrt(squares / static_cast<double>(summary.count - 1));
    summary.cv = summary.sd_s / summary.mean_s;
    summary.trend = spread > 0 ? minute * slope / spread / summary.mean_s : 0;
    return summary;
}

} // namespace

std::vector<stltsa_summary> summaries_of(std::span<const stltsa_segment> segments,
                                         std::span<const stltsa_part> cycles,
                                         std::span<const stltsa_part> repetitions) {
    std::map<int32_t, Lengths> labels;
    for (const auto parts : {cycles, repetitions}) {
        int64_t segment = -1;
        double until = 0;
        for (const stltsa_part& part : parts) {
            Lengths& of_label = labels[segments[static_cast<std::size_t>(part.segment)].label];
            of_label.add(part);
            of_label.covered += part.end_s - (part.segment == segment ? until : part.begin_s);
            segment = part.segment;
            until = part.end_s;
        }
    }
    std::vector<stltsa_summary> summaries;
    for (const auto& [label, lengths] : labels)
        summaries.push_back(summary_of(label, lengths));
    return summaries;
}

} // namespace stltsa::results
