// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/arpack.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

#include <arpack.h>

#include "base/progress.hpp"
#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"

static_assert(sizeof(a_int) == sizeof(std::int32_t), "ARPACK with 32-bit integers is needed");

// Not dseupd_c(): it copies `select` without checking that the memory for the copy was allocated.
// Fortran passes the lengths of strings after all other arguments.
extern "C" void dseupd_(const a_int* with_vectors, const char* which_vectors, a_int* select,
                        double* values, double* vectors, const a_int* stride, const double* shift,
                        const char* kind, const a_int* order, const char* which, const a_int* count,
                        const double* tolerance, double* residual, const a_int* subspace,
                        double* basis, const a_int* basis_stride, a_int* parameters,
                        a_int* pointers, double* work, double* small_work,
                        const a_int* small_work_size, a_int* info, std::size_t, std::size_t,
                        std::size_t);

namespace stltsa {
namespace {

// Not a std::timed_mutex: ThreadSanitizer of GCC 12 and helgrind do not know
// pthread_mutex_clocklock, and report that an unlocked mutex is unlocked.
[[maybe_unused]] std::mutex arpack_mutex;
[[maybe_unused]] std::condition_variable arpack_free;
[[maybe_unused]] bool arpack_used = false; ///< guarded by arpack_mutex
thread_local bool owns_arpack = false;

/// ARPACK keeps state between its reverse-communication calls (Fortran SAVE), so one eigenproblem
/// runs at a time: other threads wait, at checkpoints, meanwhile. A thread that already holds the
/// lock would wait forever.
class ArpackLock {
  public:
    ArpackLock() {
        if (owns_arpack)
            fail(Status::argument,
                 "a progress callback must not fit or decompose during stage spectrum: do so in "
                 "another stage, or before or after the call that reports progress");
        take();
        owns_arpack = true;
    }
    ~ArpackLock() {
        owns_arpack = false;
        give_back();
    }
    ArpackLock(const ArpackLock&) = delete;
    ArpackLock& operator=(const ArpackLock&) = delete;

  private:
#ifdef STLTSA_TEST_WITHOUT_ARPACK_LOCK // tests/rooms/linalg/arpack_lock.cpp
    static void take() {}
    static void give_back() {}
#else
    static void take() {
        std::unique_lock lock(arpack_mutex);
        while (!arpack_free.wait_for(lock, std::chrono::milliseconds(50),
                                     [] { return !arpack_used; })) {
            lock.unlock(); // the callback may take as long as it likes
            checkpoint();
            lock.lock();
        }
        arpack_used = true;
    }
    static void give_back() {
        const std::lock_guard lock(arpack_mutex);
        arpack_used = false;
        arpack_free.notify_one();
    }
#endif
};

/// An attempt that needs more restarts than this is repeated with twice as many Lanczos vectors: if
/// eigenvalues are close, a few vectors may never converge. The last attempt has a large limit.
constexpr a_int few_restarts = 30;
constexpr a_int many_restarts = 10000;
constexpr std::int64_t most_vectors = 80;

/// Tolerance of the residual relative to the eigenvalue. The last eigenpair decides when ARPACK
/// stops; the pairs before it, which form the embedding, are much more accurate by then, and the
/// caller corrects all of them.
constexpr double tolerance = 1e-7;

/// Lanczos vectors of the first attempt: enough that motion rarely needs a restart, which passes
/// over all of them on one thread and costs more steps in total.
std::int64_t least_vectors(std::int64_t count) {
    return 2 * count + 5;
}

/// One attempt: a sequence of reverse-communication calls of dsaupd.
class Lanczos {
  public:
    Lanczos(std::int64_t order, std::int64_t count, std::int64_t vectors, a_int most_restarts)
        : order_(static_cast<a_int>(order)), count_(static_cast<a_int>(count)),
          subspace_(static_cast<a_int>(vectors)),
          small_work_(checked_size(subspace_, subspace_ + 8)),
          basis_(Matrix::unset(subspace_, order_)), work_(Matrix::unset(3, order_)),
          residual_(Matrix::unset(1, order_)) {
        parameters_[0] = 1; // exact shifts
        parameters_[2] = most_restarts;
        parameters_[3] = 1; // block size
        parameters_[6] = 1; // mode 1: A x = lambda x
    }

    /// False if it did not converge within the restarts.
    bool iterate(const Operator& apply, const Start& start, std::int64_t& applications) {
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
            checkpoint();
        }
        if (info == 1 || info == 3)
            return false;
        if (info != 0)
            fail(Status::internal, "ARPACK dsaupd failed (info {})", info);
        return true;
    }
    std::int64_t converged() const { return parameters_[4]; }

    /// The eigenpairs; call it only once.
    Eigenpairs extract() {
        Eigenpairs pairs{Matrix::unset(count_, order_), {}, 0};
        pairs.values.resize(static_cast<std::size_t>(count_));
        std::vector<a_int> select(static_cast<std::size_t>(subspace_));
        a_int info = 0;
        // The eigenvectors overwrite the basis.
        const a_int with_vectors = 1, size = small_work_size();
        const double no_shift = 0;
        dseupd_(&with_vectors, "A", select.data(), pairs.values.data(), basis_.data(), &order_,
                &no_shift, "I", &order_, "LA", &count_, &tolerance, residual_.data(), &subspace_,
                basis_.data(), &order_, parameters_, pointers_, work_.data(), small_work_.data(),
                &size, &info, 1, 1, 2);
        if (info != 0)
            fail(Status::internal, "ARPACK dseupd failed (info {})", info);
        std::ranges::reverse(pairs.values); // dseupd returns them ascending
        for (a_int j = 0; j < count_; ++j)
            std::copy_n(basis_.row(count_ - 1 - j), order_, pairs.vectors.row(j));
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

/// Below this order the dense solver is faster and cannot break down.
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
    Eigenpairs pairs{Matrix(count, order), {}, order};
    symmetric_eigen(matrix, pairs.values); // ascending, one per row
    std::ranges::reverse(pairs.values);
    pairs.values.resize(static_cast<std::size_t>(count));
    for (std::int64_t j = 0; j < count; ++j)
        std::copy_n(matrix.row(order - 1 - j), order, pairs.vectors.row(j));
    return pairs;
}

Eigenpairs krylov_eigenpairs(const Operator& apply, std::int64_t order, const Start& start,
                             std::int64_t count) {
    const ArpackLock lock;
    const OnlyInStage refusing_fits(Stage::spectrum);
    std::int64_t applications = 0;
    for (std::int64_t vectors = least_vectors(count);; vectors *= 2) {
        const bool last = vectors >= std::min(most_vectors, order);
        Lanczos lanczos(order, count, std::min(vectors, order),
                        last ? many_restarts : few_restarts);
        if (lanczos.iterate(apply, start, applications)) {
            Eigenpairs pairs = lanczos.extract();
            pairs.applications = applications;
            return pairs;
        }
        if (last)
            fail(
                Status::not_converged,
                "the eigensolver found {} of {} eigenvalues in {} iterations; the smallest "
                "eigenvalues may be too close together: use another number of neighbors or a lower "
                "dimension",
                lanczos.converged(), count, applications);
    }
}

/// Rounding is relative to the largest eigenvalue: pairs below this share of it are computed
/// separately.
constexpr double least_share = 1e-4;

/// The number of pairs above that share.
std::int64_t known_pairs(const Eigenpairs& pairs) {
    const auto known = std::ranges::find_if(
        pairs.values, [&](double value) { return value < least_share * pairs.values[0]; });
    return std::max<std::int64_t>(1, known - pairs.values.begin());
}

/// Subtracts from x its components along these orthonormal rows.
void project_out(ConstMatrixView rows, std::span<double> x) {
    for (std::int64_t j = 0; j < rows.rows; ++j)
        axpy(-dot(rows.row(j), x.data(), rows.cols), rows.row(j), x.data(), rows.cols);
}

} // namespace

Eigenpairs largest_eigenpairs(const Operator& apply, std::int64_t order, const Start& start,
                              std::int64_t count) {
    Eigenpairs pairs = order <= std::max(dense_order, 2 * count + 8)
                           ? dense_eigenpairs(apply, order, count)
                           : krylov_eigenpairs(apply, order, start, count);
    const std::int64_t known = known_pairs(pairs);
    if (known == count)
        return pairs;
    const ConstMatrixView found = std::as_const(pairs.vectors).view().block(0, known);
    AlignedVector<double> projected(static_cast<std::size_t>(order));
    const Operator deflated = [&](std::span<const double> x, std::span<double> y) {
        std::ranges::copy(x, projected.begin());
        project_out(found, projected);
        apply(projected, y);
        project_out(found, y);
    };
    const Start deflated_start = [&](std::span<double> x) {
        start(x);
        project_out(found, x);
    };
    const Eigenpairs others = largest_eigenpairs(deflated, order, deflated_start, count - known);
    std::ranges::copy(others.values, pairs.values.begin() + known);
    std::copy_n(others.vectors.data(), others.vectors.rows() * order, pairs.vectors.row(known));
    pairs.applications += others.applications;
    return pairs;
}

} // namespace stltsa
