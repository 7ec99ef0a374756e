// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/envelope.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/panel.hpp"

namespace stltsa {

EnvelopeMatrix::EnvelopeMatrix(const std::vector<std::int64_t>& reach) {
    offset_.reserve(reach.size() + 1);
    std::int64_t total = 0;
    for (std::size_t j = 0; j < reach.size(); ++j) {
        offset_.push_back(total);
        total += reach[j] - static_cast<std::int64_t>(j) + 1;
    }
    offset_.push_back(total);
    entries_.resize(checked_size(total, 1));
}

void EnvelopeMatrix::clear(std::int64_t begin, std::int64_t end) {
    if (begin < end)
        std::fill(column(begin), column(end - 1) + (reach(end - 1) - end + 2), 0.0);
}

namespace {

/// to -= factor * from
template <int W>
STLTSA_INLINE void subtract_multiple(double factor, const double* from, double* to,
                                     std::int64_t count) {
    std::int64_t i = 0;
    for (; i + W <= count; i += W)
        store(load<Pack<W>>(to + i) - factor * load<Pack<W>>(from + i), to + i);
    for (; i < count; ++i)
        to[i] -= factor * from[i];
}

/// Rows [begin, end) between the two halves: those that the upper half reaches.
struct Middle {
    explicit Middle(const EnvelopeMatrix& matrix)
        : begin(matrix.order() / 2), end(begin > 0 ? matrix.reach(begin - 1) + 1 : begin) {}
    std::int64_t begin, end;
};

/// The columns [begin, end), with their rows before `limit`: column after column, each one's outer
/// product taken from those that it reaches.
struct FactorDown {
    EnvelopeMatrix& matrix;
    std::int64_t begin, end, limit;
    double smallest;
    const std::vector<double>& diagonal;
    bool& regular;

    template <int W>
    STLTSA_INLINE void run() const {
        regular = true;
        for (std::int64_t j = begin; j < end && regular; ++j) {
            double* column = matrix.column(j);
            regular = column[0] > smallest * diagonal[static_cast<std::size_t>(j)];
            const double pivot = __builtin_sqrt(column[0]);
            const std::int64_t length = std::min(matrix.reach(j), limit - 1) - j;
            for (std::int64_t r = 1; r <= length; ++r)
                column[r] /= pivot;
            for (std::int64_t r = 1; r <= length; ++r)
                subtract_multiple<W>(column[r], column + r, matrix.column(j + r), length - r + 1);
            column[0] = 1 / pivot; // solves wait for it: a product is sooner there than a quotient
        }
    }
};

/// What the rows from `from` on hold of columns i and j (j <= i) in common: their inner product.
double overlap(const EnvelopeMatrix& matrix, std::int64_t i, std::int64_t j, std::int64_t from) {
    const double* left = matrix.column(i) + (from - i);
    const double* right = matrix.column(j) + (from - j);
    double sum = 0;
    for (std::int64_t r = 0; r <= matrix.reach(j) - from; ++r)
        sum += left[r] * right[r];
    return sum;
}

/// The rows from the last one up to `end`: row after row, from what the rows below hold.
bool factor_up(EnvelopeMatrix& matrix, std::int64_t end, double smallest) {
    std::int64_t first = matrix.order(); // that reaches row i
    for (std::int64_t i = matrix.order() - 1; i >= end; --i) {
        double& diagonal = matrix.column(i)[0];
        const double pivot = diagonal - overlap(matrix, i, i, i + 1);
        if (!(pivot > smallest * diagonal))
            return false;
        diagonal = 1 / std::sqrt(pivot);
        while (first > 0 && matrix.reach(first - 1) >= i)
            --first;
        for (std::int64_t j = first; j < i; ++j) {
            double& entry = matrix.column(j)[i - j];
            entry = (entry - overlap(matrix, i, j, i + 1)) * diagonal;
        }
    }
    return true;
}

/// Threads that are worth starting for a matrix of this order.
int arms(const EnvelopeMatrix& matrix, const Machine& machine) {
    return threads_for(matrix.order(), 16384, machine);
}

} // namespace

bool cholesky(EnvelopeMatrix& matrix, double smallest, const Machine& machine) {
    const Middle middle(matrix);
    std::vector<double> diagonal(static_cast<std::size_t>(middle.end)); // before what is taken off
    bool down = true, up = true;
    parallel_blocks(2, arms(matrix, machine), [&](std::int64_t arm) {
        if (arm == 0) {
            for (std::int64_t j = 0; j < middle.end; ++j)
                diagonal[static_cast<std::size_t>(j)] = matrix.column(j)[0];
            run_simd(machine.simd,
                     FactorDown{matrix, 0, middle.begin, middle.end, smallest, diagonal, down});
        } else {
            up = factor_up(matrix, middle.end, smallest);
        }
    });
    if (!down || !up)
        return false;
    for (std::int64_t j = middle.begin; j < middle.end; ++j)
        for (std::int64_t i = j; i < std::min(middle.end, matrix.reach(j) + 1); ++i)
            matrix.column(j)[i - j] -= overlap(matrix, i, j, middle.end);
    run_simd(machine.simd,
             FactorDown{matrix, middle.begin, middle.end, middle.end, smallest, diagonal, down});
    return down;
}

namespace {

/// Rows that a sweep works on at a time: each value before or after them is read once for all, and
/// of the numbers that a step waits for, all but the last few are there.
constexpr int step_rows = 4;

/// The sweeps of a solve through one pack of columns. A row has everything taken off in the same
/// order, alone or in a step, and what came last, last.
template <class P>
struct Sweep {
    const EnvelopeMatrix& factor;
    MatrixView x;
    std::int64_t column;

    STLTSA_INLINE P& at(std::int64_t row) const { return pack_at<P>(x.row(row) + column); }

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

    /// Gives the rows j .. j + R - 1 their values when the rows after them, before `end`, have
    /// theirs.
    template <int R>
    STLTSA_INLINE void step_up(std::int64_t j, std::int64_t end) const {
        P value[R];
        const double* entries[R]; // of each column, from row j on
        std::int64_t last[R];
        for (int r = 0; r < R; ++r) {
            value[r] = at(j + r);
            entries[r] = factor.column(j + r) - r;
            last[r] = std::min(factor.reach(j + r), end - 1);
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
            return step_up<step_rows>(begin, factor.order());
        for (std::int64_t j = end - 1; j >= begin; --j)
            step_up<1>(j, factor.order());
    }

    STLTSA_INLINE void solve_middle(const Middle& middle) const {
        std::int64_t first = middle.begin;
        while (first > 0 && factor.reach(first - 1) >= middle.begin)
            --first;
        for (std::int64_t i = middle.begin; i < middle.end; ++i) {
            for (std::int64_t r = factor.reach(i); r >= middle.end; --r)
                at(i) -= factor.column(i)[r - i] * at(r);
            step_down<1>(i, first);
        }
        for (std::int64_t j = middle.end - 1; j >= middle.begin; --j)
            step_up<1>(j, middle.end);
    }
};

enum class Arm { upper, lower, both };

/// From the ends to the middle, or from there to the ends. Steps of the two halves take turns where
/// one thread has both: neither waits for the other, and each for itself mostly waits.
struct Halves {
    const EnvelopeMatrix& factor;
    MatrixView x;
    Arm arm;
    bool inwards;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t column) const {
        const Sweep<P> sweep{factor, x, column};
        const Middle middle(factor);
        const std::int64_t n = factor.order();
        const std::int64_t upper = arm == Arm::lower ? 0 : middle.begin;
        const std::int64_t lower = arm == Arm::upper ? 0 : n - middle.end;
        std::int64_t first = inwards ? 0 : middle.begin;
        for (std::int64_t done = 0; done < std::max(upper, lower); done += step_rows) {
            const std::int64_t upper_done = std::min(done, upper);
            const std::int64_t upper_next = std::min(done + step_rows, upper);
            const std::int64_t lower_done = std::min(done, lower);
            const std::int64_t lower_next = std::min(done + step_rows, lower);
            if (inwards) {
                sweep.down(upper_done, upper_next, first);
                sweep.up(n - lower_next, n - lower_done);
            } else {
                sweep.up(middle.begin - upper_next, middle.begin - upper_done);
                sweep.down(middle.end + lower_done, middle.end + lower_next, first);
            }
        }
    }
};

struct MiddleSolve {
    const EnvelopeMatrix& factor;
    MatrixView x;

    template <class P>
    STLTSA_INLINE void columns(std::int64_t column) const {
        Sweep<P>{factor, x, column}.solve_middle(Middle(factor));
    }
};

void sweep_halves(const EnvelopeMatrix& factor, MatrixView x, bool inwards,
                  const Machine& machine) {
    if (arms(factor, machine) == 1)
        return run_columns(x.cols, machine.simd, Halves{factor, x, Arm::both, inwards});
    parallel_blocks(2, 2, [&](std::int64_t arm) {
        run_columns(x.cols, machine.simd,
                    Halves{factor, x, arm == 0 ? Arm::upper : Arm::lower, inwards});
    });
}

} // namespace

void cholesky_solve(const EnvelopeMatrix& factor, MatrixView x, const Machine& machine) {
    sweep_halves(factor, x, true, machine);
    run_columns(x.cols, machine.simd, MiddleSolve{factor, x});
    sweep_halves(factor, x, false, machine);
}

} // namespace stltsa
