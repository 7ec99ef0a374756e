// SPDX-License-Identifier: BSD-3-Clause
// The one place where exceptions end: every entry point that can fail runs inside guard().
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "linalg/blas_integers.hpp"
#include "linalg/blas_threads.hpp"
#include "stltsa.h"

namespace stltsa::capi {

/// Keeps the text for stltsa_last_error() of this thread and returns the status.
stltsa_status remember(Status status, const char* text) noexcept;

/// What the options of a call, which may be null, ask for.
Call::Asked asked_by(const stltsa_options* options);

/// Runs body() in a Call.
template <class Body>
stltsa_status guard_call(const std::optional<Call::Asked>& asked, Body&& body) noexcept {
    try {
        const SharedThreads threads;
        const Call call(asked);
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

template <class Body>
stltsa_status guard(Body&& body) noexcept {
    return guard_call({}, body);
}

/// For functions with options: their progress callback is asked at checkpoints.
template <class Body>
stltsa_status guard(const stltsa_options* options, Body&& body) noexcept {
    return guard_call(asked_by(options), body);
}

/// For what computes: results must not depend on how BLAS splits its sums, nor on how many threads
/// it has while another thread of the program computes.
template <class Body>
auto alone_in_blas(Body& body) {
    return [&body] {
        check_blas_integers();
        const SingleThreadedBlas single;
        body();
    };
}

template <class Body>
stltsa_status compute(Body&& body) noexcept {
    return guard(alone_in_blas(body));
}

template <class Body>
stltsa_status compute(const stltsa_options* options, Body&& body) noexcept {
    return guard(options, alone_in_blas(body));
}

/// Throws for a NULL argument, naming it.
template <class T>
T& required(T* pointer, const char* name) {
    if (pointer == nullptr)
        fail(Status::argument, "{} is NULL", name);
    return *pointer;
}

} // namespace stltsa::capi
