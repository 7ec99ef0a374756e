// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/run_sums.hpp"

#include <algorithm>
#include <vector>

#include "linalg/panel.hpp"

namespace stltsa {
namespace {

/// A block of runs, [begin, end), which is summed on its own before it goes into the whole.
struct Block {
    const Aggregation& runs;
    std::int64_t begin, end;

    double length(std::int64_t run) const {
        return static_cast<double>(runs.begin(run + 1) - runs.begin(run));
    }
    double rows() const { return static_cast<double>(end_row() - first_row()); }
    std::int64_t first_row() const { return runs.begin(begin); }
    std::int64_t end_row() const { return runs.begin(end); }
};

/// Of the differences z within a block: sums(0, .) := their sum, sums(1, .) := the sum of the rows
/// that they add up to, the first of which is zero.
struct PrefixTotals {
    Block block;
    ConstMatrixView z;
    MatrixView sums;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        P sum{}, total{};
        const std::int64_t end = std::min(block.end_row(), z.rows);
        for (std::int64_t i = block.first_row(); i < end; ++i) {
            total += sum;
            sum += pack_at<P>(z.row(i) + c);
        }
        if (end < block.end_row()) // the last row has no difference after it
            total += sum;
        pack_at<P>(sums.row(0) + c) = sum;
        pack_at<P>(sums.row(1) + c) = total;
    }
};

/// x := Q^T times the rows that the differences add up to; the first one of the block is `start`
struct PrefixSums {
    Block block;
    ConstMatrixView z;
    const double* start;
    MatrixView x;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        P sum{};
        const P before = pack_at<P>(start + c);
        for (std::int64_t run = block.begin; run < block.end; ++run) {
            P total{}, moment{};
            const Aggregation::Entries& q = block.runs.entries(run);
            double from_middle = -q.middle;
            const std::int64_t end = block.runs.begin(run + 1);
            for (std::int64_t i = block.runs.begin(run); i < end; ++i, from_middle += 1) {
                const P value = before + sum;
                total += value;
                moment += from_middle * value;
                if (i < z.rows)
                    sum += pack_at<P>(z.row(i) + c);
            }
            double* to = x.row(run * block.runs.terms()) + c;
            pack_at<P>(to) = q.mean * total;
            if (block.runs.terms() > 1)
                pack_at<P>(to + x.stride) = q.slope * moment;
        }
    }
};

/// sums(0, .) := the sum of the rows
struct Sum {
    Block block;
    ConstMatrixView x;
    MatrixView sums;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        P sum{};
        for (std::int64_t run = block.begin; run < block.end; ++run)
            sum += block.runs.entries(run).mean * block.length(run) *
                   pack_at<P>(x.row(run * block.runs.terms()) + c);
        pack_at<P>(sums.row(0) + c) = sum;
    }
};

/// z(i - 1) := after + the sum of the rows from i to the end of the block, each less `mean`
struct SuffixSums {
    Block block;
    ConstMatrixView x;
    const double *mean, *after;
    MatrixView z;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t c) const {
        P sum{};
        const P beyond = pack_at<P>(after + c);
        const P shift = pack_at<P>(mean + c);
        for (std::int64_t run = block.end; run-- > block.begin;) {
            const Aggregation::Entries& q = block.runs.entries(run);
            const double* of_run = x.row(run * block.runs.terms()) + c;
            const P value = q.mean * pack_at<P>(of_run) - shift;
            const P slope = block.runs.terms() > 1 ? q.slope * pack_at<P>(of_run + x.stride) : P{};
            const std::int64_t begin = block.runs.begin(run);
            double from_middle = q.middle;
            for (std::int64_t i = block.runs.begin(run + 1); i-- > std::max<std::int64_t>(begin, 1);
                 from_middle -= 1) {
                sum += value + from_middle * slope;
                pack_at<P>(z.row(i - 1) + c) = beyond + sum;
            }
        }
    }
};

/// For each block of runs the kernel make(index, block), over the columns of a panel.
template <class MakeKernel>
void for_blocks(const Aggregation& runs, std::int64_t cols, const Machine& machine,
                const MakeKernel& make) {
    runs.for_blocks(machine, [&](std::int64_t index, std::int64_t begin, std::int64_t end) {
        run_columns(cols, machine.simd, make(index, Block{runs, begin, end}));
    });
}

} // namespace

void centered_prefix_sums(ConstMatrixView z, const Aggregation& runs, MatrixView x,
                          const Machine& machine) {
    const std::int64_t blocks = runs.blocks();
    Matrix totals(2 * blocks, z.cols);
    std::vector<double> rows(static_cast<std::size_t>(blocks));
    for_blocks(runs, z.cols, machine, [&](std::int64_t index, const Block& block) {
        rows[static_cast<std::size_t>(index)] = block.rows();
        return PrefixTotals{block, z, totals.view().block(2 * index, 2)};
    });
    Matrix starts(blocks + 1, z.cols); // the first row of each block
    Matrix mean(1, z.cols);
    for (std::int64_t b = 0; b < blocks; ++b)
        for (std::int64_t c = 0; c < z.cols; ++c) {
            mean(0, c) += totals(2 * b + 1, c) + rows[static_cast<std::size_t>(b)] * starts(b, c);
            starts(b + 1, c) = starts(b, c) + totals(2 * b, c);
        }
    for (std::int64_t b = 0; b < blocks; ++b)
        for (std::int64_t c = 0; c < z.cols; ++c)
            starts(b, c) -= mean(0, c) / static_cast<double>(runs.rows());
    for_blocks(runs, z.cols, machine, [&](std::int64_t index, const Block& block) {
        return PrefixSums{block, z, starts.row(index), x};
    });
}

void centered_suffix_sums(const Aggregation& runs, ConstMatrixView x, MatrixView z,
                          const Machine& machine) {
    const std::int64_t blocks = runs.blocks();
    Matrix sums(blocks, x.cols);
    std::vector<double> rows(static_cast<std::size_t>(blocks));
    for_blocks(runs, x.cols, machine, [&](std::int64_t index, const Block& block) {
        rows[static_cast<std::size_t>(index)] = block.rows();
        return Sum{block, x, sums.view().block(index, 1)};
    });
    Matrix mean(1, x.cols);
    for (std::int64_t b = 0; b < blocks; ++b)
        for (std::int64_t c = 0; c < x.cols; ++c)
            mean(0, c) += sums(b, c) / static_cast<double>(runs.rows());
    Matrix after(blocks, x.cols); // the sums of what is after each block
    for (std::int64_t b = blocks - 1; b > 0; --b)
        for (std::int64_t c = 0; c < x.cols; ++c)
            after(b - 1, c) =
                after(b, c) + (sums(b, c) - rows[static_cast<std::size_t>(b)] * mean(0, c));
    for_blocks(runs, x.cols, machine, [&](std::int64_t index, const Block& block) {
        return SuffixSums{block, x, mean.data(), after.row(index), z};
    });
}

} // namespace stltsa
