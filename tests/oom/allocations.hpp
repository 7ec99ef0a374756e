// SPDX-License-Identifier: BSD-3-Clause
// Counts the allocations of a program, and makes one of them fail. Included once in each program.
#pragma once

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>

namespace {

std::atomic<std::int64_t> live{0};
std::atomic<std::int64_t> until_failure{-1}; // negative: never

void* allocate(std::size_t size, std::size_t alignment) {
    if (until_failure.load() >= 0 && until_failure.fetch_sub(1) == 0)
        throw std::bad_alloc();
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
    if (memory == nullptr)
        throw std::bad_alloc();
    ++live;
    return memory;
}

void release(void* memory) noexcept {
    if (memory != nullptr)
        --live;
    std::free(memory);
}

constexpr std::size_t usual = alignof(std::max_align_t);

} // namespace

void* operator new(std::size_t size) {
    return allocate(size, usual);
}
void* operator new[](std::size_t size) {
    return allocate(size, usual);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    release(memory);
}
void operator delete[](void* memory) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    release(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    release(memory);
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
