// SPDX-License-Identifier: BSD-3-Clause
// Instruction set and threads of a computation. Results do not depend on them.
#pragma once

#include <cstdint>

#include "base/parallel.hpp"
#include "linalg/pack.hpp"

namespace stltsa {

struct Machine {
    Simd simd = widest_simd();
    int threads = 1;
};

/// Rows of a block of a long vector or panel. Each block is summed separately, which loses fewer
/// digits.
inline constexpr std::int64_t row_block = 1024;

constexpr std::int64_t row_blocks(std::int64_t rows) {
    return (rows + row_block - 1) / row_block;
}

/// Threads for work on rows; one if there are fewer than `few` rows.
constexpr int threads_for(std::int64_t rows, std::int64_t few, const Machine& machine) {
    return rows < few ? 1 : machine.threads;
}

/// Calls work(block, first row, rows) for each block.
template <class Work>
void for_row_blocks(std::int64_t rows, const Machine& machine, const Work& work) {
    constexpr std::int64_t few = 48 * row_block; // a pass over them is faster than starting threads
    parallel_blocks(row_blocks(rows), threads_for(rows, few, machine), [&](std::int64_t block) {
        const std::int64_t first = block * row_block;
        work(block, first, rows - first < row_block ? rows - first : row_block);
    });
}

} // namespace stltsa
