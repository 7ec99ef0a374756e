// SPDX-License-Identifier: BSD-3-Clause
// How far the library's embedding is from the true one of the same frames and neighborhoods.
//
//     accuracy smooth|roll|real temporal|spatial FRAMES NEIGHBORS [FOLDER]
//
// smooth: sums of sinusoids; roll: a swiss roll; real: CMU clips from FOLDER (environment
// STLTSA_DATA goes before it). Exit status 77: the clips are not there.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "fitted.hpp"
#include "real_clips.hpp"
#include "reference.hpp"
#include "stltsa.h"
#include "synthetic.hpp"

namespace {

using namespace reference;

constexpr int skipped = 77;

/// The largest errors that pass. The angle's are the library's promise; eigenvalues are relative.
struct Bounds {
    double angle;
    double eigenvalue;
};

Table<dd> widened(const Table<double>& table) {
    Table<dd> result(table.rows, table.cols);
    std::copy(table.values.begin(), table.values.end(), result.values.begin());
    return result;
}

double eigenvalue_error(const Spectrum<dd>& truth, const std::vector<double>& eigenvalues) {
    double worst = 0;
    for (std::size_t v = 0; v < truth.lambda.size(); ++v)
        worst = std::max(
            worst, static_cast<double>(abs(dd(eigenvalues[v + 1]) / truth.lambda[v] - dd(1))));
    return worst;
}

void print_header() {
    std::printf("%-10s %6s %3s %2s %9s %6s %9s %9s %6s %9s  %9s\n", "frames", "n", "k", "d",
                "lambda_2", "gap", "angle", "estimate", "ratio", "eigenval.", "plain");
}

/// One row of the table; true when it is within the bounds.
bool compare(const char* name, const Frames& frames, std::int32_t mode, std::size_t k,
             const Spectrum<dd>& truth, const Spectrum<double>& plain, const Bounds& bounds) {
    const std::size_t d = truth.coords.rows;
    const Fitted fitted = fit(frames, mode, k, k, d);
    const double angle = static_cast<double>(largest_angle(truth.coords, widened(fitted.coords)));
    const double plain_angle =
        static_cast<double>(largest_angle(truth.coords, widened(plain.coords)));
    const double eigenvalue = eigenvalue_error(truth, fitted.eigenvalues);
    const bool ok = angle < bounds.angle && fitted.error_estimate >= angle / 10 &&
                    eigenvalue < bounds.eigenvalue;
    std::printf("%-10s %6zu %3zu %2zu %9.2e %6.2f %9.2e %9.2e %6.1f %9.2e  %9.2e%s\n", name,
                frames.rows, k, d, static_cast<double>(truth.lambda[0]),
                static_cast<double>(truth.lambda[d] / truth.lambda[d - 1]), angle,
                fitted.error_estimate, fitted.error_estimate / angle, eigenvalue, plain_angle,
                ok ? "" : "  FAILED");
    std::fflush(stdout);
    return ok;
}

/// The rows of one data set, d = 1 .. 3 as far as its channels go.
bool compare_dimensions(const char* name, const Frames& frames, std::int32_t mode, std::size_t k,
                        const Bounds& bounds) {
    const std::size_t most = std::min<std::size_t>(3, frames.cols - 1);
    const Neighbors neighbors = mode == STLTSA_MODE_TEMPORAL ? temporal_neighbors(frames, k, k)
                                                             : spatial_neighbors(frames, k);
    const auto truth = embed<dd>(frames, neighbors, most);
    const auto plain = embed<double>(frames, neighbors, most);
    print_header();
    bool ok = true;
    for (std::size_t d = 1; d <= most; ++d)
        ok = compare(name, frames, mode, k, truth[d - 1], plain[d - 1], bounds) && ok;
    return ok;
}

struct Arguments {
    std::string data;
    std::int32_t mode;
    std::size_t frames;
    std::size_t neighbors;
    std::string folder;
};

bool compare_data(const Arguments& a) {
    if (a.data == "real")
        return compare_dimensions("real", real_chain(a.folder, a.frames), a.mode, a.neighbors,
                                  {1e-10, 1e-9});
    if (a.data == "roll")
        return compare_dimensions("roll", swiss_roll(a.frames, 1), a.mode, a.neighbors,
                                  {1e-10, 1e-9});
    // At most 3 cycles a second at 120 frames a second: harder than any clip measured.
    return compare_dimensions("smooth", smooth_curve(a.frames, 56, 3.0 / 120, 1), a.mode,
                              a.neighbors, {1e-7, 1e-6});
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        std::fprintf(stderr, "usage: accuracy smooth|roll|real temporal|spatial FRAMES NEIGHBORS "
                             "[FOLDER]\n");
        return EXIT_FAILURE;
    }
    Arguments arguments{
        argv[1], argv[2] == std::string("spatial") ? STLTSA_MODE_SPATIAL : STLTSA_MODE_TEMPORAL,
        std::strtoul(argv[3], nullptr, 10), std::strtoul(argv[4], nullptr, 10),
        argc > 5 ? argv[5] : "../shared/data"};
    if (const char* variable = std::getenv("STLTSA_DATA"))
        arguments.folder = variable;
    if (arguments.data == "real" && !has_real_clips(arguments.folder)) {
        std::printf("SKIPPED: no real clips in %s (set STLTSA_DATA to their folder)\n",
                    arguments.folder.c_str());
        return skipped;
    }
    try {
        return compare_data(arguments) ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "accuracy: %s\n", error.what());
        return EXIT_FAILURE;
    }
}
