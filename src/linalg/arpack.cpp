// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/arpack.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include <arpack.h>
#include <cblas.h>

#include "linalg/eigen.hpp"
#include "linalg/panel.hpp"
#include "linalg/simd.hpp"

static_assert(sizeof(a_int) == sizeof(std::int32_t), "ARPACK with 32-bit integers is needed");

namespace stltsa {
namespace {

/// ARPACK keeps state between its reverse-communication calls (Fortran SAVE), so one eigenproblem
/// runs at a time.
std::mutex arpack_mutex;

/// A run that needs more restarts than this is repeated with twice as many Lanczos vectors: where
/// eigenvalues lie close, a few vectors may circle for ever. The last run has all the time.
constexpr a_int few_restarts = 30;
constexpr a_int many_restarts = 10000;
constexpr std::int64_t most_vectors = 80;

/// Eigenpairs whose residual is less, relative to their eigenvalue, count as found. The last one
/// decides; those before it, which make up the embedding, are known much better by then, and the
/// caller corrects all of them.
constexpr double tolerance = 1e-7;

/// Lanczos vectors at first: so many that motion mostly needs no restart, which is a pass over all
/// of them, on one thread, and more steps in the end.
std::int64_t least_vectors(std::int64_t count) {
    return 2 * count + 5;
}

/// The `count` largest pairs that an operator has in the span of a basis, from its inner products
/// with that basis.
Eigenpairs ritz_pairs(Matrix projected, Matrix basis, std::int64_t count) {
    const std::int64_t order = projected.rows();
    Eigenpairs pairs{std::move(basis), Matrix(order, count), {}, {}, 0};
    pairs.errors.resize(static_cast<std::size_t>(count));
    symmetric_eigen(projected, pairs.values); // ascending, one per row
    std::reverse(pairs.values.begin(), pairs.values.end());
    for (std::int64_t j = 0; j < count; ++j)
        for (std::int64_t m = 0; m < order; ++m)
            pairs.coefficients(m, j) = projected(order - 1 - j, m);
    return pairs;
}

/// One run of dsaupd's reverse communication.
class Lanczos {
  public:
    Lanczos(std::int64_t order, std::int64_t count, std::int64_t vectors, a_int most_restarts,
            const Machine& machine)
        : order_(static_cast<a_int>(order)), count_(static_cast<a_int>(count)),
          subspace_(static_cast<a_int>(vectors)),
          small_work_(checked_size(subspace_, subspace_ + 8)),
          basis_(Matrix::unset(subspace_, order_)), work_(Matrix::unset(3, order_)),
          residual_(Matrix::unset(1, order_)) {
        // ARPACK, which has one thread, would be the first to touch this memory.
        for (Matrix* memory : {&basis_, &work_, &residual_})
            clear({memory->data(), memory->cols(), memory->rows(), memory->rows()}, machine);
        parameters_[0] = 1; // exact shifts
        parameters_[2] = most_restarts;
        parameters_[3] = 1; // block size
        parameters_[6] = 1; // mode 1: A x = lambda x
    }

    /// False where there were too few restarts.
    bool iterate(const Operator& apply, const Start& start, const std::function<void()>& poll,
                 std::int64_t& applications) {
        const auto length = static_cast<std::size_t>(order_);
        start({residual_.data(), length});
        a_int ido = 0;
        a_int info = 1; // start from residual_
        for (;;) {
            dsaupd_c(&ido, "I", order_, "LA", count_, tolerance, residual_.data(), subspace_,
                     basis_.data(), order_, parameters_, pointers_, work_.data(),
                     small_work_.data(), small_work_size(), &info);
            if (ido != 1 && ido != -1)
                break;
            apply({work_.data() + pointers_[0] - 1, length},
                  {work_.data() + pointers_[1] - 1, length});
            ++applications;
            poll();
        }
        if (info == 1 || info == 3)
            return false;
        if (info != 0)
            fail(Status::internal, "ARPACK dsaupd failed (info {})", info);
        return true;
    }
    std::int64_t converged() const { return parameters_[4]; }

    /// The Ritz pairs of the basis as it is; once only. dseupd would write the vectors out, on one
    /// thread and in several passes.
    Eigenpairs extract() {
        // Documented: the off-diagonal of the projected matrix from its second entry on, then the
        // diagonal.
        const double* off_diagonal = small_work_.data() + pointers_[4] - 1;
        const double* diagonal = off_diagonal + subspace_;
        Matrix projected(subspace_, subspace_);
        for (a_int i = 0; i < subspace_; ++i) {
            projected(i, i) = diagonal[i];
            if (i > 0)
                projected(i, i - 1) = projected(i - 1, i) = off_diagonal[i];
        }
        Eigenpairs pairs = ritz_pairs(std::move(projected), std::move(basis_), count_);
        // What an application leaves outside of the basis belongs to its last vector.
        const double left = cblas_dnrm2(order_, residual_.data(), 1);
        for (std::int64_t j = 0; j < count_; ++j)
            pairs.errors[static_cast<std::size_t>(j)] =
                left * std::abs(pairs.coefficients(subspace_ - 1, j));
        return pairs;
    }

  private:
    a_int small_work_size() const { return static_cast<a_int>(small_work_.size()); }

    a_int order_, count_, subspace_;
    AlignedVector<double> small_work_;
    Matrix basis_, work_, residual_;
    a_int parameters_[11] = {};
    a_int pointers_[11] = {};
};

/// Below this order a dense problem is both quicker and free of Lanczos breakdown.
constexpr std::int64_t dense_order = 64;

Eigenpairs dense_eigenpairs(const Operator& apply, std::int64_t order, std::int64_t count) {
    Matrix matrix(order, order);
    AlignedVector<double> unit(static_cast<std::size_t>(order));
    for (std::int64_t i = 0; i < order; ++i) {
        unit[static_cast<std::size_t>(i)] = 1;
        apply(unit, {matrix.row(i), static_cast<std::size_t>(order)});
        unit[static_cast<std::size_t>(i)] = 0;
    }
    for (std::int64_t i = 0; i < order; ++i)
        for (std::int64_t j = 0; j < i; ++j)
            matrix(i, j) = matrix(j, i) = 0.5 * (matrix(i, j) + matrix(j, i));
    Matrix basis(order, order);
    for (std::int64_t i = 0; i < order; ++i)
        basis(i, i) = 1;
    Eigenpairs pairs = ritz_pairs(std::move(matrix), std::move(basis), count);
    pairs.applications = order;
    return pairs;
}

Eigenpairs krylov_eigenpairs(const Operator& apply, std::int64_t order, const Start& start,
                             std::int64_t count, const Machine& machine,
                             const std::function<void()>& poll) {
    const std::lock_guard lock(arpack_mutex);
    std::int64_t applications = 0;
    for (std::int64_t vectors = least_vectors(count);; vectors *= 2) {
        const bool last = vectors >= std::min(most_vectors, order);
        Lanczos lanczos(order, count, std::min(vectors, order), last ? many_restarts : few_restarts,
                        machine);
        if (lanczos.iterate(apply, start, poll, applications)) {
            Eigenpairs pairs = lanczos.extract();
            pairs.applications = applications;
            return pairs;
        }
        if (last)
            fail(Status::not_converged,
                 "the eigensolver found {} of {} eigenvalues in {} iterations; the smallest "
                 "eigenvalues may not be separated: try another number of neighbors or a lower "
                 "dimension",
                 lanczos.converged(), count, applications);
    }
}

/// Pairs are rounded relative to the largest eigenvalue: what is below this share of it is looked
/// for on its own.
constexpr double least_share = 1e-4;

/// The pairs that are known well.
std::int64_t known_pairs(const Eigenpairs& pairs) {
    std::int64_t known = 1;
    while (known < pairs.coefficients.cols() &&
           pairs.values[static_cast<std::size_t>(known)] >= least_share * pairs.values[0])
        ++known;
    return known;
}

/// The vectors of the first pairs, one per row.
Matrix vectors_of(const Eigenpairs& pairs, std::int64_t count) {
    Matrix vectors(count, pairs.basis.cols());
    for (std::int64_t j = 0; j < count; ++j)
        for (std::int64_t m = 0; m < pairs.basis.rows(); ++m)
            axpy(pairs.coefficients(m, j), pairs.basis.row(m), vectors.row(j), vectors.cols());
    return vectors;
}

/// Takes what it has of these orthonormal rows off x.
void take_off(const Matrix& rows, std::span<double> x) {
    for (std::int64_t j = 0; j < rows.rows(); ++j)
        axpy(-dot(rows.row(j), x.data(), rows.cols()), rows.row(j), x.data(), rows.cols());
}

/// The first `known` of these pairs, and after them those that were found beside them.
Eigenpairs joined(const Eigenpairs& pairs, std::int64_t known, Matrix vectors,
                  const Eigenpairs& others) {
    const std::int64_t more = others.coefficients.cols();
    Eigenpairs all{Matrix::unset(known + others.basis.rows(), vectors.cols()),
                   Matrix(known + others.basis.rows(), known + more), pairs.values, pairs.errors,
                   pairs.applications + others.applications};
    std::copy_n(vectors.data(), known * vectors.cols(), all.basis.data());
    std::copy_n(others.basis.data(), others.basis.rows() * vectors.cols(), all.basis.row(known));
    for (std::int64_t j = 0; j < known; ++j)
        all.coefficients(j, j) = 1;
    for (std::int64_t m = 0; m < others.basis.rows(); ++m)
        std::copy_n(others.coefficients.row(m), more, all.coefficients.row(known + m) + known);
    all.values.resize(static_cast<std::size_t>(known));
    all.errors.resize(static_cast<std::size_t>(known));
    all.values.insert(all.values.end(), others.values.begin(), others.values.end());
    all.errors.insert(all.errors.end(), others.errors.begin(), others.errors.end());
    return all;
}

} // namespace

Eigenpairs largest_eigenpairs(const Operator& apply, std::int64_t order, const Start& start,
                              std::int64_t count, const Machine& machine,
                              const std::function<void()>& poll) {
    Eigenpairs pairs = order <= std::max(dense_order, 2 * count + 8)
                           ? dense_eigenpairs(apply, order, count)
                           : krylov_eigenpairs(apply, order, start, count, machine, poll);
    const std::int64_t known = known_pairs(pairs);
    if (known == count)
        return pairs;
    Matrix vectors = vectors_of(pairs, known);
    AlignedVector<double> rest(static_cast<std::size_t>(order));
    const Operator beside = [&](std::span<const double> x, std::span<double> y) {
        std::ranges::copy(x, rest.begin());
        take_off(vectors, rest);
        apply(rest, y);
        take_off(vectors, y);
    };
    const Start start_beside = [&](std::span<double> x) {
        start(x);
        take_off(vectors, x);
    };
    const Eigenpairs others =
        largest_eigenpairs(beside, order, start_beside, count - known, machine, poll);
    return joined(pairs, known, std::move(vectors), others);
}

} // namespace stltsa
