// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/envelope.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "linalg/panel.hpp"

namespace stltsa {

EnvelopeColumns::EnvelopeColumns(Offsets offset) : offset_(std::move(offset)) {
    entries_.resize(checked_size(offset_.back(), 1));
}

void EnvelopeColumns::clear(std::int64_t begin, std::int64_t end) {
    if (begin < end)
        std::fill(column(begin), column(end - 1) + (reach(end - 1) - end + 2), 0.0);
}

namespace {

/// Threads that are worth starting for a matrix of this order.
int arms(std::int64_t order, const Machine& machine) {
    return threads_for(order, 16384, machine);
}

using Reach = std::vector<std::int64_t>;
using Offsets = EnvelopeColumns::Offsets;

/// Of columns whose last row is reach(column).
template <class ReachOf>
void set_offsets(const ReachOf& reach, Offsets& offset) {
    std::int64_t total = 0;
    for (std::size_t j = 0; j + 1 < offset.size(); ++j) {
        offset[j] = total;
        const auto column = static_cast<std::int64_t>(j);
        total += reach(column) - column + 1;
    }
    offset.back() = total;
}

/// Of the first arm, with the rows before `end`.
void set_first_offsets(const Reach& reach, std::int64_t end, Offsets& offset) {
    set_offsets(
        [&](std::int64_t column) {
            return std::min(reach[static_cast<std::size_t>(column)], end - 1);
        },
        offset);
}

/// Of the second arm, with the rows from `begin` on: those from `middle_end` on are its own, and
/// those before them it may reach all.
void set_last_offsets(const Reach& reach, std::int64_t begin, std::int64_t middle_end,
                      Offsets& offset) {
    const auto order = static_cast<std::int64_t>(reach.size());
    std::int64_t first = order; // that reaches the row
    set_offsets(
        [&](std::int64_t column) {
            const std::int64_t row = order - 1 - column;
            if (row < middle_end)
                return order - 1 - begin;
            while (first > 0 && reach[static_cast<std::size_t>(first - 1)] >= row)
                --first;
            return order - 1 - first;
        },
        offset);
}

} // namespace

// All memory is taken by this thread: what malloc has for another one is fresh for each call.
EnvelopeMatrix::EnvelopeMatrix(const Reach& reach, const Machine& machine)
    : order_(static_cast<std::int64_t>(reach.size())) {
    const std::int64_t begin = order_ / 2;
    const std::int64_t end = begin > 0 ? reach[static_cast<std::size_t>(begin - 1)] + 1 : begin;
    Offsets first(static_cast<std::size_t>(end) + 1);
    Offsets last(static_cast<std::size_t>(order_ - begin) + 1);
    parallel_blocks(2, arms(order_, machine), [&](std::int64_t arm) {
        if (arm == 0)
            set_first_offsets(reach, end, first);
        else
            set_last_offsets(reach, begin, end, last);
    });
    arms_[0] = {EnvelopeColumns(std::move(first)), begin};
    arms_[1] = {EnvelopeColumns(std::move(last)), order_ - end};
    arms_[1].columns.clear(order_ - end, order_ - begin);
}

namespace {

/// to -= factor * from, in packs of W and then of half as many, and so on: columns are short.
template <int W>
STLTSA_INLINE void subtract_multiple(double factor, const double* from, double* to,
                                     std::int64_t count) {
    std::int64_t i = 0;
    for (; i + W <= count; i += W)
        store(load<Pack<W>>(to + i) - factor * load<Pack<W>>(from + i), to + i);
    if constexpr (W > 2)
        subtract_multiple<W / 2>(factor, from + i, to + i, count - i);
    else if (i < count)
        to[i] -= factor * from[i];
}

/// What diagonal entries were before anything was taken off, of columns that are reached and not
/// eliminated: no more than the longest column has entries.
class Diagonal {
  public:
    Diagonal() = default;
    explicit Diagonal(const EnvelopeColumns& columns) {
        std::int64_t longest = 1;
        for (std::int64_t j = 0; j < columns.order(); ++j)
            longest = std::max(longest, columns.reach(j) - j + 1);
        entries_.resize(std::bit_ceil(static_cast<std::size_t>(longest)));
    }
    double& operator[](std::int64_t column) {
        return entries_[static_cast<std::size_t>(column) & (entries_.size() - 1)];
    }

  private:
    AlignedVector<double> entries_;
};

/// The columns [begin, end), one after another: each one's outer product is taken from those that
/// it reaches. `diagonal` has the columns before `reached`.
struct Elimination {
    EnvelopeColumns& matrix;
    std::int64_t begin, end;
    double smallest;
    Diagonal& diagonal;
    std::int64_t reached;
    bool& regular;

    template <int W>
    STLTSA_INLINE void run() const {
        std::int64_t fresh = reached;
        bool large = true; // what threads write must not be side by side: here, not `regular`
        for (std::int64_t j = begin; j < end && large; ++j) {
            double* column = matrix.column(j);
            const std::int64_t length = matrix.reach(j) - j;
            for (; fresh <= j + length; ++fresh)
                diagonal[fresh] = matrix.column(fresh)[0];
            large = column[0] > smallest * diagonal[j];
            const double pivot = __builtin_sqrt(column[0]);
            for (std::int64_t r = 1; r <= length; ++r)
                column[r] /= pivot;
            for (std::int64_t r = 1; r <= length; ++r)
                subtract_multiple<W>(column[r], column + r, matrix.column(j + r), length - r + 1);
            column[0] = 1 / pivot; // solves wait for it: a product is sooner there than a quotient
        }
        regular = large;
    }
};

/// Takes what the second arm takes off the middle off the entries in the first.
void join_middle(EnvelopeMatrix& matrix) {
    const EnvelopeColumns& second = matrix.arm(1).columns;
    for (std::int64_t j = matrix.middle_begin(); j < matrix.middle_end(); ++j)
        for (std::int64_t i = j; i <= matrix.arm(0).columns.reach(j); ++i)
            matrix.entry(i, j) += second.column(matrix.order() - 1 - i)[i - j];
}

} // namespace

bool cholesky(EnvelopeMatrix& matrix, double smallest, const Machine& machine) {
    Diagonal diagonals[2];
    bool regular[2];
    parallel_blocks(2, arms(matrix.order(), machine), [&](std::int64_t index) {
        auto& [columns, own] = matrix.arm(static_cast<int>(index));
        diagonals[index] = Diagonal(columns);
        run_simd(machine.simd,
                 Elimination{columns, 0, own, smallest, diagonals[index], 0, regular[index]});
    });
    if (!regular[0] || !regular[1])
        return false;
    join_middle(matrix);
    run_simd(machine.simd,
             Elimination{matrix.arm(0).columns, matrix.middle_begin(), matrix.middle_end(),
                         smallest, diagonals[0], matrix.middle_end(), regular[0]});
    return regular[0];
}

namespace {

/// Rows that a sweep works on at a time: each value before or after them is read once for all, and
/// of the numbers that a step waits for, all but the last few are there.
constexpr int step_rows = 4;

/// The sweeps of a solve through one pack of columns of x, in the order of rows of one arm. A row
/// has everything taken off in the same order, alone or in a step, and what came last, last.
template <class P>
struct Sweep {
    const EnvelopeColumns& factor;
    std::int64_t own;
    double* first_row;
    std::ptrdiff_t to_next_row;

    STLTSA_INLINE Sweep(const EnvelopeMatrix& matrix, int arm, MatrixView x, std::int64_t column)
        : factor(matrix.arm(arm).columns), own(matrix.arm(arm).own),
          first_row(x.row(arm == 0 ? 0 : x.rows - 1) + column),
          to_next_row(arm == 0 ? x.stride : -x.stride) {}

    STLTSA_INLINE P& at(std::int64_t row) const {
        return pack_at<P>(first_row + row * to_next_row);
    }

    /// Gives the rows i .. i + R - 1 their values when the columns before have theirs; `first`
    /// follows the first column that reaches row i.
    template <int R>
    STLTSA_INLINE void step_down(std::int64_t i, std::int64_t& first) const {
        P value[R];
        for (int r = 0; r < R; ++r)
            value[r] = at(i + r);
        while (factor.reach(first) < i)
            ++first;
        std::int64_t c = first;
        for (; c < i && factor.reach(c) < i + R - 1; ++c)
            for (int r = 0; r < R - 1; ++r)
                if (i + r <= factor.reach(c))
                    value[r] -= factor.column(c)[i + r - c] * at(c);
        for (; c < i; ++c) {
            const double* entries = factor.column(c) + (i - c);
            const P before = at(c);
            for (int r = 0; r < R; ++r)
                value[r] -= entries[r] * before;
        }
        for (int s = 0; s < R; ++s) {
            const double* entries = factor.column(i + s);
            value[s] *= entries[0];
            for (int r = s + 1; r < R; ++r)
                if (i + r <= factor.reach(i + s))
                    value[r] -= entries[r - s] * value[s];
        }
        for (int r = 0; r < R; ++r)
            at(i + r) = value[r];
    }

    /// Gives the rows j .. j + R - 1 their values when the rows after them have theirs.
    template <int R>
    STLTSA_INLINE void step_up(std::int64_t j) const {
        P value[R];
        const double* entries[R]; // of each column, from row j on
        std::int64_t last[R];
        for (int r = 0; r < R; ++r) {
            value[r] = at(j + r);
            entries[r] = factor.column(j + r) - r;
            last[r] = factor.reach(j + r);
        }
        std::int64_t i = last[R - 1];
        for (; i >= j + R && i > last[0]; --i)
            for (int r = 1; r < R; ++r)
                if (i <= last[r])
                    value[r] -= entries[r][i - j] * at(i);
        for (; i >= j + R; --i) {
            const P after = at(i);
            for (int r = 0; r < R; ++r)
                value[r] -= entries[r][i - j] * after;
        }
        for (int s = R - 1; s >= 0; --s) {
            value[s] *= entries[s][s];
            for (int r = 0; r < s; ++r)
                if (j + s <= last[r])
                    value[r] -= entries[r][s] * value[s];
        }
        for (int r = 0; r < R; ++r)
            at(j + r) = value[r];
    }

    /// At most step_rows rows.
    STLTSA_INLINE void down(std::int64_t begin, std::int64_t end, std::int64_t& first) const {
        if (end - begin == step_rows)
            return step_down<step_rows>(begin, first);
        for (std::int64_t i = begin; i < end; ++i)
            step_down<1>(i, first);
    }
    STLTSA_INLINE void up(std::int64_t begin, std::int64_t end) const {
        if (end - begin == step_rows)
            return step_up<step_rows>(begin);
        for (std::int64_t j = end - 1; j >= begin; --j)
            step_up<1>(j);
    }

    /// Takes off the rows in the middle what the arm's own columns hold of them.
    STLTSA_INLINE void take_off_middle() const {
        for (std::int64_t c = own; c-- > 0 && factor.reach(c) >= own;)
            for (std::int64_t i = own; i <= factor.reach(c); ++i)
                at(i) -= factor.column(c)[i - c] * at(c);
    }
    /// Gives the rows in the middle, which this arm has the entries of, their values.
    STLTSA_INLINE void solve_middle() const {
        std::int64_t first = own;
        while (first > 0 && factor.reach(first - 1) >= own)
            --first;
        for (std::int64_t i = own; i < factor.order(); ++i)
            step_down<1>(i, first);
        for (std::int64_t j = factor.order() - 1; j >= own; --j)
            step_up<1>(j);
    }
};

/// From the ends to the middle, or from there to the ends. Steps of the arms take turns where one
/// thread has both: neither waits for the other, and each for itself mostly waits.
struct SweepArms {
    const EnvelopeMatrix& factor;
    MatrixView x;
    int begin, end; ///< arms
    bool inwards;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t column) const {
        const Sweep<P> sweeps[] = {{factor, begin, x, column}, {factor, end - 1, x, column}};
        std::int64_t first[] = {0, 0};
        const std::int64_t rows = std::max(sweeps[0].own, sweeps[1].own);
        for (std::int64_t done = 0; done < rows; done += step_rows)
            for (int a = 0; a < end - begin; ++a) {
                const Sweep<P>& sweep = sweeps[a];
                const std::int64_t from = std::min(done, sweep.own);
                const std::int64_t to = std::min(done + step_rows, sweep.own);
                if (inwards)
                    sweep.down(from, to, first[a]);
                else
                    sweep.up(sweep.own - to, sweep.own - from);
            }
    }
};

struct SolveMiddle {
    const EnvelopeMatrix& factor;
    MatrixView x;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t column) const {
        Sweep<P>{factor, 1, x, column}.take_off_middle();
        Sweep<P>{factor, 0, x, column}.solve_middle();
    }
};

void sweep_arms(const EnvelopeMatrix& factor, MatrixView x, bool inwards, const Machine& machine) {
    if (arms(factor.order(), machine) == 1)
        return run_columns(x.cols, machine.simd, SweepArms{factor, x, 0, 2, inwards});
    parallel_blocks(2, 2, [&](std::int64_t arm) {
        const int first = static_cast<int>(arm);
        run_columns(x.cols, machine.simd, SweepArms{factor, x, first, first + 1, inwards});
    });
}

} // namespace

void cholesky_solve(const EnvelopeMatrix& factor, MatrixView x, const Machine& machine) {
    sweep_arms(factor, x, true, machine);
    run_columns(x.cols, machine.simd, SolveMiddle{factor, x});
    sweep_arms(factor, x, false, machine);
}

} // namespace stltsa
