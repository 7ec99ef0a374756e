// SPDX-License-Identifier: BSD-3-Clause
// Memory for numbers.
#pragma once

#include <cstddef>
#include <limits>
#include <new>

namespace stltsa {

/// Aligned to 64 bytes: BLAS kernels take the same path, so give the same bits, on every run. Large
/// blocks are asked for in large pages where the system has them: a million frames are a gigabyte,
/// and the system's work on each small page of it was a quarter of the time of a fit.
void* allocate_aligned(std::size_t bytes);
void free_aligned(void* data, std::size_t bytes) noexcept;

template <class T>
struct AlignedAllocator {
    using value_type = T;
    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}
    T* allocate(std::size_t count) {
        if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
            throw std::bad_alloc();
        return static_cast<T*>(allocate_aligned(count * sizeof(T)));
    }
    void deallocate(T* data, std::size_t count) { free_aligned(data, count * sizeof(T)); }
    template <class U>
    bool operator==(const AlignedAllocator<U>&) const {
        return true;
    }
};

} // namespace stltsa
