// SPDX-License-Identifier: BSD-3-Clause
#include "base/checkpoint.hpp"
#include "clip/acclaim/skeleton_file.hpp"
#include "clip/clip.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

void append_frame(std::string& text, const Skeleton& skeleton, const double* row) {
    for (const Joint& joint : skeleton.joints) {
        if (joint.channels.empty())
            continue;
        text += joint.name;
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            text += ' ';
            append_number(text, *row++);
        }
        text += '\n';
    }
}

} // namespace

std::string format_amc(const Clip& clip) {
    if (!clip.skeleton || clip.format != Format::amc)
        fail(Status::unsupported, "only a clip read from AMC can be written as AMC, because its "
                                  "skeleton is a separate ASF file: write .bvh or .csv");
    std::string text = ":FULLY-SPECIFIED\n";
    if (clip.fps > 0 && clip.fps != amc_fps) { // only if needed: few files have this line
        text += ":SAMPLES-PER-SECOND ";
        append_number(text, clip.fps);
        text += '\n';
    }
    text += ":DEGREES\n";
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        text += format_text("{}\n", i + 1);
        append_frame(text, *clip.skeleton, clip.values.row(i));
        checkpoint(work_of_number * clip.values.cols());
    }
    return text;
}

} // namespace stltsa::clip
