// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/sparse_factor.hpp"

#include <algorithm>
#include <new>

#include <suitesparse/cholmod.h>

#include "base/error.hpp"

// From the OpenMP runtime that CHOLMOD may be linked with; null without one.
extern "C" {
[[gnu::weak]] int omp_get_max_active_levels();
[[gnu::weak]] void omp_set_max_active_levels(int levels);
}

namespace stltsa {
namespace {

/// During its lifetime OpenMP starts no threads for the calling thread. CHOLMOD's loops use a fixed
/// number of threads (4 in Debian 12) regardless of its settings. They would outlive the call, and
/// a process that forks afterwards would wait for them forever.
class WithoutOpenMp {
  public:
    WithoutOpenMp() {
        if (omp_set_max_active_levels == nullptr || omp_get_max_active_levels == nullptr)
            return;
        levels_ = omp_get_max_active_levels();
        if (levels_ > 0)
            omp_set_max_active_levels(0);
    }
    ~WithoutOpenMp() {
        if (levels_ > 0)
            omp_set_max_active_levels(levels_);
    }
    WithoutOpenMp(const WithoutOpenMp&) = delete;
    WithoutOpenMp& operator=(const WithoutOpenMp&) = delete;

  private:
    int levels_ = 0;
};

/// The matrix for CHOLMOD, without copying.
cholmod_sparse view_of(SparseColumns& matrix) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(matrix.order);
    view.nzmax = matrix.values.size();
    view.p = matrix.begin.data();
    view.i = matrix.rows.data();
    view.x = matrix.values.data();
    view.stype = -1; // lower triangle
    view.itype = CHOLMOD_LONG;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

/// CHOLMOD's columns are rows here.
cholmod_dense view_of(MatrixView rows) {
    cholmod_dense view{};
    view.nrow = static_cast<std::size_t>(rows.cols);
    view.ncol = static_cast<std::size_t>(rows.rows);
    view.d = static_cast<std::size_t>(rows.stride);
    view.nzmax = view.d * view.ncol;
    view.x = rows.data;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    return view;
}

} // namespace

struct SparseFactor::State {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    cholmod_dense *result = nullptr, *work_y = nullptr, *work_e = nullptr;

    State() {
        cholmod_l_start(&common);
        common.print = 0; // the library never prints
        // AMD is the best ordering for these graphs and always available.
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        // L L^T also where it is not supernodal: L D L^T would accept negative pivots.
        common.final_ll = 1;
    }
    ~State() {
        cholmod_l_free_dense(&result, &common);
        cholmod_l_free_dense(&work_y, &common);
        cholmod_l_free_dense(&work_e, &common);
        cholmod_l_free_factor(&factor, &common);
        cholmod_l_finish(&common);
    }
    State(const State&) = delete;

    /// cholmod_l_solve2() would allocate these itself, but crashes if memory runs out for the first
    /// and not for the second (SuiteSparse 5.12; tests/oom, "fit recurrent").
    void allocate_work(std::size_t columns) {
        if (factor->is_super == 0)
            return;
        cholmod_l_ensure_dense(&work_y, factor->n, columns, factor->n, factor->xtype, &common);
        check();
        cholmod_l_ensure_dense(&work_e, columns, factor->maxesize, columns, factor->xtype, &common);
        check();
    }

    void check() const {
        if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
            throw std::bad_alloc();
        if (common.status < 0)
            fail(Status::internal, "CHOLMOD failed (status {})", common.status);
    }
};

SparseFactor::SparseFactor(SparseColumns& matrix) : state_(std::make_unique<State>()) {
    const WithoutOpenMp one_thread;
    cholmod_sparse view = view_of(matrix);
    state_->factor = cholmod_l_analyze(&view, &state_->common);
    state_->check();
}

SparseFactor::~SparseFactor() = default;

bool SparseFactor::factorize(SparseColumns& matrix, double shift) {
    const WithoutOpenMp one_thread;
    cholmod_sparse view = view_of(matrix);
    double beta[2] = {shift, 0};
    cholmod_l_factorize_p(&view, beta, nullptr, 0, state_->factor, &state_->common);
    state_->check();
    return state_->factor->minor == state_->factor->n;
}

double SparseFactor::pivot_ratio() const {
    return cholmod_l_rcond(state_->factor, &state_->common);
}

void SparseFactor::solve(MatrixView rows) {
    const WithoutOpenMp one_thread;
    cholmod_dense right = view_of(rows);
    state_->allocate_work(right.ncol);
    cholmod_l_solve2(CHOLMOD_A, state_->factor, &right, nullptr, &state_->result, nullptr,
                     &state_->work_y, &state_->work_e, &state_->common);
    state_->check();
    const auto* solution = static_cast<const double*>(state_->result->x);
    for (std::int64_t r = 0; r < rows.rows; ++r)
        std::copy_n(solution + r * rows.cols, rows.cols, rows.row(r));
}

} // namespace stltsa
