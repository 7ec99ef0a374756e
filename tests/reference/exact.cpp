// SPDX-License-Identifier: BSD-3-Clause
// Reads frames from a file of doubles and writes their exact embedding to another file, for
// scripts/benchmark:
//
//     exact FILE FRAMES FEATURES temporal|spatial NEIGHBORS DIMENSION COORDS
//
// temporal: the nearest among as many frames to each side, including the frame itself. spatial: the
// nearest among all other frames, as in other programs.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

#include "reference.hpp"

namespace {

using namespace reference;

Frames read_frames(const std::string& path, std::size_t rows, std::size_t cols) {
    Frames frames(rows, cols);
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(frames.values.data()),
                   static_cast<std::streamsize>(rows * cols * sizeof(double))))
        throw std::runtime_error(path + ": cannot be read, or has fewer frames");
    return frames;
}

/// A frame is its own nearest neighbor, so it is in the list.
Neighbors without_self(const Neighbors& with_self) {
    Neighbors result(with_self.rows, with_self.cols - 1);
    for (std::size_t i = 0; i < result.rows; ++i) {
        std::size_t filled = 0;
        for (std::size_t j = 0; j < with_self.cols && filled < result.cols; ++j)
            if (with_self(i, j) != i)
                result(i, filled++) = with_self(i, j);
    }
    return result;
}

/// Rows are frames.
void write_coords(const Table<dd>& coords, const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    for (std::size_t i = 0; i < coords.cols; ++i)
        for (std::size_t l = 0; l < coords.rows; ++l) {
            const double value = static_cast<double>(coords(l, i));
            file.write(reinterpret_cast<const char*>(&value), sizeof value);
        }
    if (!file.flush())
        throw std::runtime_error(path + ": cannot be written");
}

void run(char** arguments) {
    const std::size_t k = std::stoul(arguments[4]);
    const std::size_t d = std::stoul(arguments[5]);
    const Frames frames =
        read_frames(arguments[0], std::stoul(arguments[1]), std::stoul(arguments[2]));
    const Neighbors neighbors = arguments[3] == std::string("temporal")
                                    ? temporal_neighbors(frames, k, k)
                                    : without_self(spatial_neighbors(frames, k + 1));
    write_coords(embed(neighbors, local_tangents<dd>(frames, neighbors, d), d).coords,
                 arguments[6]);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 8) {
        std::fprintf(stderr, "usage: exact FILE FRAMES FEATURES temporal|spatial NEIGHBORS "
                             "DIMENSION COORDS\n");
        return EXIT_FAILURE;
    }
    try {
        run(argv + 1);
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "exact: %s\n", error.what());
        return EXIT_FAILURE;
    }
}
