// SPDX-License-Identifier: BSD-3-Clause
// Measures the distance of the library's embedding from the exact one for the same frames and
// neighborhoods, next to the results of other algorithms.
//
//     accuracy smooth|roll|real temporal|spatial FRAMES NEIGHBORS DIMENSIONS [FOLDER]
//
// smooth: sums of sinusoids; roll: a swiss roll; real: CMU clips from FOLDER (the environment
// variable STLTSA_DATA takes precedence). DIMENSIONS: one digit for each dimension, such as 123.
// Exit status 77: the clips are missing.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>

#include "fitted.hpp"
#include "real_clips.hpp"
#include "reference.hpp"
#include "stltsa.h"
#include "synthetic.hpp"

namespace {

using namespace reference;

constexpr int skipped = 77;

/// Rotations take too long for neighborhoods larger than this, and for neighborhoods without a
/// band.
constexpr std::size_t most_rotated = 40;

/// Limits of the errors. The limit of the angle is the library's promise; eigenvalues are relative.
struct Bounds {
    double angle;
    double eigenvalue;
};

struct Arguments {
    std::string data;
    std::int32_t mode;
    std::size_t frames;
    std::size_t neighbors;
    std::string dimensions;
    std::string folder;
};

Frames frames_of(const Arguments& a) {
    if (a.data == "real")
        return real_chain(a.folder, a.frames);
    if (a.data == "roll")
        return swiss_roll(a.frames, 1);
    // At most 3 cycles per second at 120 frames per second: harder than any measured clip.
    return smooth_curve(a.frames, 56, 3.0 / 120, 1);
}

Bounds bounds_of(const Arguments& a) {
    return a.data == "smooth" ? Bounds{1e-8, 1e-6} : Bounds{1e-11, 1e-9};
}

double eigenvalue_error(const Spectrum<dd>& truth, const std::vector<double>& eigenvalues) {
    double worst = 0;
    for (std::size_t v = 0; v < truth.lambda.size(); ++v)
        worst = std::max(
            worst, static_cast<double>(abs(dd(eigenvalues[v + 1]) / truth.lambda[v] - dd(1))));
    return worst;
}

/// A problem for several algorithms.
struct Problem {
    const Arguments& arguments;
    Frames frames;
    Neighbors neighbors;
    Tangents<dd> tangents;
    Tangents<double> plain_tangents;

    bool temporal() const { return arguments.mode == STLTSA_MODE_TEMPORAL; }
};

Problem problem_of(const Arguments& a) {
    Frames frames = frames_of(a);
    Neighbors neighbors = a.mode == STLTSA_MODE_TEMPORAL
                              ? temporal_neighbors(frames, a.neighbors, a.neighbors)
                              : spatial_neighbors(frames, a.neighbors);
    const auto most =
        static_cast<std::size_t>(*std::max_element(a.dimensions.begin(), a.dimensions.end()) - '0');
    auto exact = local_tangents<dd>(frames, neighbors, most);
    auto plain = local_tangents<double>(frames, neighbors, most);
    return {a, std::move(frames), std::move(neighbors), std::move(exact), std::move(plain)};
}

void print_header() {
    std::printf("%-6s %7s %3s %2s %9s %5s %9s %9s %6s %9s   %9s %9s %9s %9s\n", "frames", "n", "k",
                "d", "lambda_2", "gap", "angle", "estimate", "ratio", "eigenval.", "rotations",
                "plain", "B + 1e-9", "B + 1e-12");
}

/// Prints an angle, or a dash if there is none.
void print_angle(double angle) {
    if (angle < 0)
        std::printf(" %9s", "-");
    else
        std::printf(" %9.2e", angle);
}

/// Angles between the results of other algorithms and the exact embedding; -1 if there is none.
struct OtherWays {
    double rotations = -1;
    double plain = -1;
    double by_shift[2] = {-1, -1};
};

OtherWays other_ways(const Problem& problem, const Spectrum<dd>& truth) {
    const std::size_t d = truth.coords.rows;
    const auto angle_to = [&truth](const Table<double>& coords) {
        return static_cast<double>(largest_angle(truth.coords, widened(coords)));
    };
    OtherWays ways;
    if (problem.temporal() && problem.neighbors.cols <= most_rotated)
        ways.rotations =
            angle_to(embed_by_rotations(problem.neighbors, problem.plain_tangents, d).coords);
    ways.plain = angle_to(embed(problem.neighbors, problem.plain_tangents, d).coords);
    constexpr double shifts[] = {1e-9, 1e-12};
    for (int s = 0; s < 2; ++s)
        if (const auto coords =
                embed_by_shift(problem.neighbors, problem.plain_tangents, d, shifts[s]))
            ways.by_shift[s] = angle_to(*coords);
    return ways;
}

/// Prints one row of the table; true if it is within the limits.
bool compare(const Problem& problem, std::size_t d, const Bounds& bounds) {
    const Spectrum<dd> truth = embed(problem.neighbors, problem.tangents, d);
    const std::size_t k = problem.neighbors.cols;
    const Fitted fitted = fit(problem.frames, problem.arguments.mode, k, k, d);
    const double angle = static_cast<double>(largest_angle(truth.coords, widened(fitted.coords)));
    const double eigenvalue = eigenvalue_error(truth, fitted.eigenvalues);
    const OtherWays ways = other_ways(problem, truth);
    const bool ok = angle < bounds.angle && fitted.error_estimate >= angle / 10 &&
                    eigenvalue < bounds.eigenvalue && ways.rotations < bounds.angle;
    std::printf("%-6s %7zu %3zu %2zu %9.2e %5.2f %9.2e %9.2e %6.1f %9.2e  ",
                problem.arguments.data.c_str(), problem.frames.rows, k, d,
                static_cast<double>(truth.lambda[0]),
                static_cast<double>(truth.lambda[d] / truth.lambda[d - 1]), angle,
                fitted.error_estimate, fitted.error_estimate / angle, eigenvalue);
    print_angle(ways.rotations);
    print_angle(ways.plain);
    print_angle(ways.by_shift[0]);
    print_angle(ways.by_shift[1]);
    std::printf("%s\n", ok ? "" : "  FAILED");
    std::fflush(stdout);
    return ok;
}

bool compare_dimensions(const Arguments& arguments) {
    const Problem problem = problem_of(arguments);
    const Bounds bounds = bounds_of(arguments);
    std::printf("angle and rotations below %.0e, eigenvalues %.0e, estimate / angle above 0.1:\n",
                bounds.angle, bounds.eigenvalue);
    print_header();
    bool ok = true;
    for (const char digit : arguments.dimensions)
        ok = compare(problem, static_cast<std::size_t>(digit - '0'), bounds) && ok;
    return ok;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 6 || std::string(argv[5]).find_first_not_of("123456789") != std::string::npos) {
        std::fprintf(stderr, "usage: accuracy smooth|roll|real temporal|spatial FRAMES "
                             "NEIGHBORS DIMENSIONS [FOLDER]\n");
        return EXIT_FAILURE;
    }
    Arguments arguments{argv[1],
                        argv[2] == std::string("spatial") ? STLTSA_MODE_SPATIAL
                                                          : STLTSA_MODE_TEMPORAL,
                        std::strtoul(argv[3], nullptr, 10),
                        std::strtoul(argv[4], nullptr, 10),
                        argv[5],
                        argc > 6 ? argv[6] : "../shared/data"};
    if (const char* variable = std::getenv("STLTSA_DATA"))
        arguments.folder = variable;
    if (arguments.data == "real" && !has_real_clips(arguments.folder)) {
        std::printf("SKIPPED: no real clips in %s (set STLTSA_DATA to their folder)\n",
                    arguments.folder.c_str());
        return skipped;
    }
    try {
        return compare_dimensions(arguments) ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "accuracy: %s\n", error.what());
        return EXIT_FAILURE;
    }
}
