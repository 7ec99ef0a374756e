// SPDX-License-Identifier: BSD-3-Clause
// Writes a walk as text: the BVH file and the JSON with its borders.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "body.hpp"
#include "walker.hpp"

namespace walker {
namespace {

void write_joint(std::string& out, const Body& body, std::size_t j, int depth,
                 const std::string& rotations) {
    const JointInfo& joint = body[j];
    const std::string tab(static_cast<std::size_t>(depth), '\t');
    const bool root = joint.parent < 0;
    out += fmt::format("{}{} {}\n{}{{\n", tab, root ? "ROOT" : "JOINT", joint.name, tab);
    out += fmt::format("{}\tOFFSET {:.6f} {:.6f} {:.6f}\n", tab, joint.offset.x, joint.offset.y,
                       joint.offset.z);
    out += fmt::format("{}\tCHANNELS {}{}\n", tab, root ? "6 Xposition Yposition Zposition" : "3",
                       rotations);
    for (std::size_t child = j + 1; child < body.size(); ++child)
        if (body[child].parent == static_cast<int>(j))
            write_joint(out, body, child, depth + 1, rotations);
    if (joint.end)
        out +=
            fmt::format("{0}\tEnd Site\n{0}\t{{\n{0}\t\tOFFSET {1:.6f} {2:.6f} {3:.6f}\n{0}\t}}\n",
                        tab, joint.end->x, joint.end->y, joint.end->z);
    out += tab + "}\n";
}

nlohmann::ordered_json to_json(const Interval& i) {
    return {{"kind", i.kind},
            {"begin", i.begin},
            {"end", i.end},
            {"begin_s", i.begin_s},
            {"end_s", i.end_s}};
}

nlohmann::ordered_json to_json(const std::vector<Interval>& intervals) {
    auto list = nlohmann::ordered_json::array();
    for (const Interval& i : intervals)
        list.push_back(to_json(i));
    return list;
}

} // namespace

std::string bvh_text(const Walk& walk) {
    std::string rotations;
    for (const char axis : walk.settings.order)
        rotations += fmt::format(" {}rotation", axis);
    std::string out = "HIERARCHY\n";
    write_joint(out, make_body(walk.settings.height), hips, 0, rotations);
    out += fmt::format("MOTION\nFrames: {}\nFrame Time: {}\n", walk.frames, 1 / walk.settings.fps);
    for (std::size_t i = 0; i < walk.channels.size(); ++i)
        fmt::format_to(std::back_inserter(out), "{:.6f}{}", walk.channels[i],
                       (i + 1) % channel_count == 0 ? '\n' : ' ');
    return out;
}

std::string borders_text(const Walk& walk) {
    nlohmann::ordered_json out;
    out["format"] = "stltsa-walker/1";
    out["clip"] = {{"frames", walk.frames}, {"fps", walk.settings.fps}};
    out["period_s"] = walk.period;
    out["units"] = to_json(walk.units);
    out["cycles"] = to_json(walk.cycles);
    return out.dump(1) + "\n";
}

} // namespace walker
