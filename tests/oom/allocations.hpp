// SPDX-License-Identifier: BSD-3-Clause
// Counts the allocations of a program, and makes one of them fail. Included once in each program.
// Replaces the C functions for every library in the process: operator new, LAPACKE, CHOLMOD, zlib,
// libstdc++, and the directories and streams of the C library call them.
#pragma once

#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <link.h>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);
}

namespace {

std::atomic<std::int64_t> live{0};
std::atomic<std::int64_t> until_failure{-1}; // negative: never
std::atomic<bool> no_memory{false};          // every allocation fails

/// Address ranges of libraries that end the process if an allocation fails (docs/robustness.md);
/// their own allocations always succeed.
struct Spared {
    const char* name;
    std::uintptr_t begin = 0, end = 0;
    std::atomic<std::int64_t> times{0};
    std::atomic<std::int64_t> until_failure{-1}; // of its own allocations (endings.cpp)

    bool contains(std::uintptr_t at) const { return at >= begin && at < end; }
};
Spared spared[] = {{"libopenblas"}, {"libgomp"}};

[[maybe_unused]] int find_spared(dl_phdr_info* library, std::size_t, void*) {
    for (Spared& s : spared)
        for (int i = 0; i < library->dlpi_phnum; ++i) {
            const auto& part = library->dlpi_phdr[i];
            if (std::string_view(library->dlpi_name).find(s.name) == std::string_view::npos ||
                part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0)
                continue;
            s.begin = library->dlpi_addr + part.p_vaddr;
            s.end = s.begin + part.p_memsz;
        }
    return 0;
}

/// `caller`: the code that allocates.
bool fails(void* caller) {
    const auto at = reinterpret_cast<std::uintptr_t>(caller);
    for (Spared& s : spared)
        if (s.until_failure.load() >= 0 && s.contains(at) && s.until_failure.fetch_sub(1) == 0)
            return true;
    if (no_memory.load())
        return true;
    if (until_failure.load() < 0 || until_failure.fetch_sub(1) != 0)
        return false;
    for (Spared& s : spared)
        if (s.contains(at)) {
            ++s.times;
            return false;
        }
    return true;
}

bool refused(void* caller) {
    const bool refuses = fails(caller);
    if (refuses)
        errno = ENOMEM;
    return refuses;
}

void* counted(void* memory) {
    if (memory != nullptr)
        ++live;
    return memory;
}

} // namespace

extern "C" {
void* malloc(std::size_t size) noexcept {
    return refused(__builtin_return_address(0)) ? nullptr : counted(__libc_malloc(size));
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    return refused(__builtin_return_address(0)) ? nullptr : counted(__libc_calloc(count, size));
}
void* realloc(void* memory, std::size_t size) noexcept {
    if (refused(__builtin_return_address(0)))
        return nullptr;
    void* moved = __libc_realloc(memory, size);
    return memory == nullptr ? counted(moved) : moved;
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return refused(__builtin_return_address(0)) ? nullptr
                                                : counted(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return refused(__builtin_return_address(0)) ? nullptr
                                                : counted(__libc_memalign(alignment, size));
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
    void* made =
        refused(__builtin_return_address(0)) ? nullptr : counted(__libc_memalign(alignment, size));
    if (made == nullptr)
        return ENOMEM;
    *memory = made;
    return 0;
}
void free(void* memory) noexcept {
    if (memory != nullptr)
        --live;
    __libc_free(memory);
}
}

/// Eight channels of a motion of period 1 s at 30 fps, as CSV.
inline std::string cyclic_csv() {
    std::string text = "a,b,c,d,e,f,g,h\n";
    for (int i = 0; i < 150; ++i)
        for (int c = 0; c < 8; ++c)
            text += std::to_string(std::sin(2 * M_PI * i / 30.0 * (1 + c % 2) + c) + 0.001 * i) +
                    (c < 7 ? "," : "\n");
    return text;
}
