// SPDX-License-Identifier: BSD-3-Clause
// The one place where exceptions end: every entry point that can fail runs inside guard().
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "linalg/blas_integers.hpp"
#include "linalg/blas_threads.hpp"
#include "stltsa.h"

namespace stltsa::capi {

/// Keeps the text for stltsa_last_error() of this thread and returns the status.
stltsa_status remember(Status status, const char* text) noexcept;

template <class Body>
stltsa_status guard(Body&& body) noexcept {
    try {
        const SharedThreads threads;
        body();
        return STLTSA_OK;
    } catch (const Error& error) {
        return remember(error.status(), error.what());
    } catch (const std::bad_alloc&) {
        return remember(Status::no_memory, "out of memory");
    } catch (const std::length_error&) {
        return remember(Status::no_memory, "out of memory: a size does not fit");
    } catch (const std::exception& error) {
        return remember(Status::internal, error.what());
    } catch (...) {
        return remember(Status::internal, "an unknown exception");
    }
}

/// guard() for what computes: results must not depend on how BLAS splits its sums, nor on how many
/// threads it has while another thread of the program computes.
template <class Body>
stltsa_status compute(Body&& body) noexcept {
    return guard([&] {
        check_blas_integers();
        const SingleThreadedBlas single;
        body();
    });
}

/// Throws for a NULL argument, naming it.
template <class T>
T& required(T* pointer, const char* name) {
    if (pointer == nullptr)
        fail(Status::argument, "{} is NULL", name);
    return *pointer;
}

} // namespace stltsa::capi
