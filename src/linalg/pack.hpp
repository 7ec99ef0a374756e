// SPDX-License-Identifier: BSD-3-Clause
// Vectors of doubles as wide as the machine's registers; one source, the width chosen at run time.
// Each element undergoes the operations of a scalar in the same order, and the compiler may not
// contract them: results have the same bits for every width.
#pragma once

#include <cstdint>

// Code for a width must be inlined into the function that is compiled for it.
#define STLTSA_INLINE [[gnu::always_inline]] inline
#define STLTSA_INLINE_LAMBDA __attribute__((always_inline))

namespace stltsa {

/// Instruction sets that loops over packs are compiled for: the baseline of the build (SSE2 on
/// x86-64, NEON on arm64), and AVX2, which only some machines have.
enum class Simd : std::int32_t { baseline, avx2 };

/// The widest instruction set of this machine.
inline Simd widest_simd() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") != 0)
        return Simd::avx2;
#endif
    return Simd::baseline;
}

/// Doubles in a pack.
constexpr int simd_width(Simd simd) {
    return simd == Simd::avx2 ? 4 : 2;
}

namespace detail {

template <int W>
struct PackOf {
    typedef double type __attribute__((vector_size(8 * W), may_alias));
};

template <class Kernel>
void run_baseline(const Kernel& kernel) {
    kernel.template run<2>();
}
#ifdef __x86_64__
template <class Kernel>
[[gnu::target("avx2")]] void run_avx2(const Kernel& kernel) {
    kernel.template run<4>();
}
#endif

} // namespace detail

/// W doubles, with the arithmetic and comparisons of one.
template <int W>
using Pack = typename detail::PackOf<W>::type;

/// Loads a pack or a single number from an unaligned address.
template <class P>
STLTSA_INLINE P load(const double* from) {
    P pack;
    __builtin_memcpy(&pack, from, sizeof pack);
    return pack;
}
template <class P>
STLTSA_INLINE void store(P pack, double* to) {
    __builtin_memcpy(to, &pack, sizeof pack);
}

/// Calls kernel.run<W>() compiled for `simd`, which must be available. run() and the functions that
/// it calls with packs are STLTSA_INLINE.
template <class Kernel>
void run_simd([[maybe_unused]] Simd simd, const Kernel& kernel) {
#ifdef __x86_64__
    if (simd == Simd::avx2)
        return detail::run_avx2(kernel);
#endif
    detail::run_baseline(kernel);
}

template <class P>
STLTSA_INLINE P square_root(P v) {
    for (unsigned l = 0; l < sizeof(P) / sizeof(double); ++l)
        v[l] = __builtin_sqrt(v[l]);
    return v;
}

template <class P>
STLTSA_INLINE P magnitude(P v) {
    return v < 0 ? -v : v;
}

} // namespace stltsa
