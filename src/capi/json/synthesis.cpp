// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "capi/json/parts.hpp"

namespace stltsa::capi {
namespace {

Json made_clip(const clip::Clip& clip) {
    return JsonObject("format", json_name(clip.format), "frames", clip.frames(), "fps", clip.fps,
                      "duration_s", static_cast<double>(clip.frames()) / clip.fps);
}

Json pieces_json(std::span<const PieceFacts> pieces) {
    std::vector<Json> list;
    for (const PieceFacts& piece : pieces)
        list.push_back(JsonObject("path", json_string_or_null(piece.path), "begin", piece.begin,
                                  "end", piece.end, "repeat", piece.repeat));
    return list;
}

/// null if the clip is no loop.
Json loop_json(const Synthesized& synthesized) {
    if (!synthesized.result.loop)
        return nullptr;
    const synthesis::Loop& loop = *synthesized.result.loop;
    return JsonObject("in_place", synthesized.options.in_place, "travel",
                      std::vector<double>(loop.travel.begin(), loop.travel.end()), "distance",
                      std::hypot(loop.travel[0], loop.travel[1], loop.travel[2]), "turn_deg",
                      loop.turn * 180 / std::numbers::pi, "coverage", loop.coverage, "cycles",
                      json_count_or_null(loop.cycles), "source_cycles",
                      json_count_or_null(loop.source_cycles), "notes", synthesized.result.notes);
}

/// The wrap of a loop has as its frame the number of frames.
Json seams_json(const std::vector<synthesis::Seam>& seams, std::int64_t frames, double fps) {
    std::vector<Json> list;
    for (const synthesis::Seam& seam : seams)
        list.push_back(
            JsonObject("frame", seam.frame, "time_s", static_cast<double>(seam.frame) / fps,
                       "piece", seam.piece, "next", seam.next, "cut_end", seam.cut_end, "cut_begin",
                       seam.cut_begin, "crossfade", seam.crossfade, "crossfade_s",
                       static_cast<double>(seam.crossfade) / fps, "posture", seam.posture, "step",
                       seam.step, "acceleration", seam.acceleration, "wrap", seam.frame == frames));
    return list;
}

} // namespace

std::string synthesis_json(const clip::Clip& clip, const Synthesized& synthesized) {
    const synthesis::Synthesis& made = synthesized.result;
    JsonObject object = json_head("synthesis");
    object.set("clip", made_clip(clip));
    object.set("pieces", pieces_json(synthesized.pieces));
    object.set("parameters",
               JsonObject("crossfade_s", json_or_null(synthesized.options.crossfade), "cut_range_s",
                          json_or_null(synthesized.options.search), "posture_limit",
                          json_positive_or_null(synthesized.options.posture_limit), "up_axis",
                          json_axis(made.up)));
    object.set("loop", loop_json(synthesized));
    object.set("seams", seams_json(made.seams, clip.frames(), clip.fps));
    object.set("warnings", json_warnings(made.warnings));
    return object.text();
}

} // namespace stltsa::capi
