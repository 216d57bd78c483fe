#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <immintrin.h>
#endif

/// Single-precision numbers side by side in one register, as wide as the processor has them that the program is built
/// for. Nobody needs this folder for the assignment.
///
/// No compiler makes a number of the signs of a comparison by itself, nor moves those that are met to the front: these
/// two steps are instructions where a processor has them, and short loops elsewhere. They give the same bits.
namespace rt {

#if defined(__AVX512DQ__) && defined(__AVX512VL__)
constexpr int wide = 16;
#elif defined(__AVX__)
constexpr int wide = 8;
#else
constexpr int wide = 4;
#endif
constexpr int half_wide = wide < 8 ? wide : 8;  // at most the children of a node

// Extensions of GCC and Clang.
using Floats = float __attribute__((vector_size(4 * wide)));
using FewFloats = float __attribute__((vector_size(4 * half_wide)));

template <class V>
[[gnu::always_inline]] inline V load(const float* from) {
    V v;
    std::memcpy(&v, from, sizeof v);
    return v;
}

template <class V>
[[gnu::always_inline]] inline V lesser(V a, V b) {
    return a < b ? a : b;
}

template <class V>
[[gnu::always_inline]] inline V greater(V a, V b) {
    return a > b ? a : b;
}

template <int n>
struct FloatsOf {
    using Vector __attribute__((vector_size(4 * n))) = float;
};

/// The least of the first n numbers, half against half: one by one, each step would wait for the one before.
template <int n = wide>
[[gnu::always_inline]] inline float least_of(const void* numbers) {
    typename FloatsOf<n / 2>::Vector halves[2];
    std::memcpy(halves, numbers, sizeof halves);
    const auto least = lesser(halves[0], halves[1]);
    if constexpr (n > 4)
        return least_of<n / 2>(&least);
    else
        return least[0] < least[1] ? least[0] : least[1];
}

/// Bit k: a[k] <= b[k].
template <class V>
[[gnu::always_inline]] inline unsigned not_above(V a, V b) {
#ifdef __AVX512VL__
    if constexpr (sizeof(V) == 64) return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
    if constexpr (sizeof(V) == 32) return _mm256_cmp_ps_mask(a, b, _CMP_LE_OQ);
#elif defined(__AVX__)
    if constexpr (sizeof(V) == 32) return unsigned(_mm256_movemask_ps(a <= b));
#elif defined(__SSE2__)
    if constexpr (sizeof(V) == 16) return unsigned(_mm_movemask_ps(a <= b));
#else
    unsigned bits = 0;
    for (unsigned k = 0; k < sizeof(V) / sizeof(float); ++k) bits |= unsigned(a[k] <= b[k]) << k;
    return bits;
#endif
}

/// Where a ray enters and leaves the eight boxes of a node's children.
struct alignas(64) Ways {
    float enter[8], leave[8];
};

/// Writes enter << 32 | child of each child that the ray meets, in the order of the numbers k ^ turn; eight places are
/// written.
///
/// turn  0 or 7
[[gnu::always_inline]] inline void write_met(const Ways& ways, const std::uint32_t* child, unsigned turn,
                                             std::uint64_t* to) {
#ifdef __AVX512VL__
    const __m256i order = _mm256_xor_si256(_mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0), _mm256_set1_epi32(int(turn)));
    const __m256 enter = _mm256_permutexvar_ps(order, _mm256_load_ps(ways.enter)),
                 leave = _mm256_permutexvar_ps(order, _mm256_load_ps(ways.leave));
    const __mmask8 met = _mm256_cmp_ps_mask(enter, leave, _CMP_LE_OQ);
    const __m256i low = _mm256_permutevar8x32_epi32(_mm256_load_si256(reinterpret_cast<const __m256i*>(child)), order);
    const __m512i all =
        _mm512_or_si512(_mm512_maskz_cvtepu32_epi64(met, low),
                        _mm512_maskz_slli_epi64(met, _mm512_maskz_cvtepu32_epi64(met, _mm256_castps_si256(enter)), 32));
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi64(met, all));
#else
    int n = 0;
    for (unsigned k = 0; k < 8; ++k) {
        const unsigned c = k ^ turn;
        to[n] = std::uint64_t(std::bit_cast<std::uint32_t>(ways.enter[c])) << 32 | child[c];
        n += ways.enter[c] <= ways.leave[c];
    }
#endif
}

}  // namespace rt
