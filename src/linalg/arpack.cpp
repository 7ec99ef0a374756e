// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/arpack.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include <arpack.h>

#include "linalg/eigen.hpp"
#include "linalg/panel.hpp"

static_assert(sizeof(a_int) == sizeof(std::int32_t), "ARPACK with 32-bit integers is needed");

namespace stltsa {
namespace {

/// ARPACK keeps state between its reverse-communication calls (Fortran SAVE), so one eigenproblem
/// runs at a time, from the first call of dsaupd to the end of dseupd.
std::mutex arpack_mutex;

/// A run that needs more restarts than this is repeated with twice as many Lanczos vectors: where
/// eigenvalues lie close, a few vectors may circle for ever. The last run has all the time.
constexpr a_int few_restarts = 30;
constexpr a_int many_restarts = 10000;
constexpr std::int64_t most_vectors = 80;

/// Eigenpairs whose residual is less, relative to their eigenvalue, count as found. The last one
/// decides; those before it, which make up the embedding, are known much better by then, and the
/// caller corrects all of them.
constexpr double tolerance = 1e-9;

/// Lanczos vectors at first.
std::int64_t least_vectors(std::int64_t count) {
    return 2 * count + 3;
}

/// One run of dsaupd's reverse communication, then dseupd.
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

    /// Once only: the vectors take the place of the basis.
    Eigenpairs extract() {
        Eigenpairs pairs{std::vector<double>(static_cast<std::size_t>(count_)), std::move(basis_),
                         0};
        std::vector<a_int> select(static_cast<std::size_t>(subspace_), 1);
        a_int info = 0;
        dseupd_c(1, "A", select.data(), pairs.values.data(), pairs.vectors.data(), order_, 0.0, "I",
                 order_, "LA", count_, tolerance, residual_.data(), subspace_, pairs.vectors.data(),
                 order_, parameters_, pointers_, work_.data(), small_work_.data(),
                 small_work_size(), &info);
        if (info != 0)
            fail(Status::internal, "ARPACK dseupd failed (info {})", info);
        pairs.vectors.keep_rows(count_);
        // dseupd gives ascending order.
        std::reverse(pairs.values.begin(), pairs.values.end());
        for (std::int64_t r = 0; r < count_ / 2; ++r)
            std::swap_ranges(pairs.vectors.row(r), pairs.vectors.row(r) + order_,
                             pairs.vectors.row(count_ - 1 - r));
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
    std::vector<double> values;
    symmetric_eigen(matrix, values);
    Eigenpairs pairs{{}, Matrix(count, order), order};
    for (std::int64_t r = 0; r < count; ++r) {
        pairs.values.push_back(values[static_cast<std::size_t>(order - 1 - r)]);
        std::copy_n(matrix.row(order - 1 - r), order, pairs.vectors.row(r));
    }
    return pairs;
}

} // namespace

Eigenpairs largest_eigenpairs(const Operator& apply, std::int64_t order, const Start& start,
                              std::int64_t count, const Machine& machine,
                              const std::function<void()>& poll) {
    if (order <= std::max(dense_order, 2 * count + 8))
        return dense_eigenpairs(apply, order, count);
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

} // namespace stltsa
