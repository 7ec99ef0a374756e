// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/memory.hpp"

#include <sys/mman.h>

namespace stltsa {
namespace {

constexpr std::align_val_t cache_line{64};
constexpr std::size_t large_page = std::size_t{2} << 20;

/// Below some pages, what the ends of a block waste would be more than is gained.
bool is_large(std::size_t bytes) {
    return bytes >= 4 * large_page;
}

std::align_val_t alignment_of(std::size_t bytes) {
    return is_large(bytes) ? std::align_val_t{large_page} : cache_line;
}

} // namespace

void* allocate_aligned(std::size_t bytes) {
    void* data = ::operator new(bytes, alignment_of(bytes));
#ifdef MADV_HUGEPAGE
    if (is_large(bytes))
        (void)madvise(data, bytes, MADV_HUGEPAGE); // where it cannot, pages stay small
#endif
    return data;
}

void free_aligned(void* data, std::size_t bytes) noexcept {
    ::operator delete(data, alignment_of(bytes));
}

} // namespace stltsa
