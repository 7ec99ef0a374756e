// SPDX-License-Identifier: BSD-3-Clause
// The command stltsa-walker: writes a synthetic walk as BVH and its borders as JSON.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "walker.hpp"

namespace {

void write(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        throw std::runtime_error("cannot write " + path);
}

} // namespace

int main(int argc, char** argv) {
    walker::Settings s;
    std::string output;
    std::string borders;
    CLI::App app("Writes a synthetic walk (BVH) and the exact borders of its motion units (JSON).");
    app.add_option("-o,--output", output, "BVH file to write")->required();
    app.add_option("--borders", borders, "JSON file to write; default: the BVH's name with .json");
    app.add_option("--fps", s.fps, "frames per second")->capture_default_str();
    app.add_option("--cycles", s.cycles, "cycles of two steps")->capture_default_str();
    app.add_option("--period", s.period, "seconds per cycle")->capture_default_str();
    app.add_option_function<double>(
        "--stand", [&](double stand) { s.stand_before = s.stand_after = stand; },
        "seconds of standing, before and after the walk");
    app.add_option("--stand-before", s.stand_before, "seconds of standing before")
        ->capture_default_str();
    app.add_option("--stand-after", s.stand_after, "seconds of standing after")
        ->capture_default_str();
    app.add_option("--stride", s.stride, "factor on the joint angles of normal walking")
        ->capture_default_str();
    app.add_option("--ramp", s.ramp, "gain in tempo from the first landing to the last; 0.2: 20 %")
        ->capture_default_str();
    app.add_option("--sway", s.sway, "sway of the standing body, degrees rms")
        ->capture_default_str();
    app.add_option("--turn", s.turn, "degrees to the left per cycle")->capture_default_str();
    app.add_option("--height", s.height, "height of the body in cm")->capture_default_str();
    app.add_flag("--right-first", s.right_first, "step first with the right foot");
    app.add_option("--noise", s.noise, "standard deviation in degrees on every rotation channel")
        ->capture_default_str();
    app.add_option("--seed", s.seed, "seed of the noise")->capture_default_str();
    app.add_option("--t-pose", s.t_pose_frames, "frames at the start in which a T-pose fades")
        ->capture_default_str();
    app.add_option("--order", s.order, "order of the rotation channels")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        if (borders.empty())
            borders = std::filesystem::path(output).replace_extension(".json").string();
        const walker::Walk walk = walker::make_walk(s);
        write(output, walker::bvh_text(walk));
        write(borders, walker::borders_text(walk));
    } catch (const std::exception& e) {
        std::fprintf(stderr, "stltsa-walker: %s\n", e.what());
        return 1;
    }
    return 0;
}
