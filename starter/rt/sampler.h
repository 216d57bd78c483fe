#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "rt/fragments.h"

/// Random numbers and sampling patterns. A number depends only on where it is used: the pixel's key, the sample's index
/// and the dimension. Nothing is stored, so any thread can draw any number.
namespace rt {

using Bits = std::uint64_t;

/// A bijection of 64 bits that leaves no visible structure.
///
/// Source: Stafford's variant 13 of the MurmurHash3 finaliser; Steele, Lea, Flood, OOPSLA 2014.
inline Bits mix(Bits x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// A key made of a key and a number: of a pixel from the seed, of a path's branch from the pixel.
inline Bits combine(Bits key, Bits number) { return mix(key + 0x9e3779b97f4a7c15u * (number + 1)); }

/// The upper 52 bits as a number, 0 <= x < 1.
inline Real to_unit(Bits x) { return std::bit_cast<Real>((x >> 12) | 0x3ff0000000000000u) - 1; }

/// An independent random number for sample i in a dimension.
inline Real random_1d(Bits key, Bits i, Bits dimension) { return to_unit(combine(combine(key, dimension), i)); }

inline vec2 random_2d(Bits key, Bits i, Bits dimension) {
    const Bits x = combine(combine(key, dimension), i);
    const Real u = to_unit(x);
    const Real v = to_unit(mix(x + 0x9e3779b97f4a7c15u));
    return {u, v};
}

inline std::uint32_t reversed(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
    x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
    return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

/// Owen scrambling of a number whose bits are reversed: each bit is flipped or not by a hash of the bits below it.
///
/// Source: Laine and Karras, "Stratified Sampling for Stochastic Transparency", EGSR 2011; constants of Vegdahl, 2021.
inline std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526c56u;
    return x ^ (x * 0x53a22864u);
}

/// The product of Pascal's triangle mod 2 with the bits of x: the second dimension of Sobol's sequence, bits reversed.
inline std::uint32_t pascal(std::uint32_t x) {
    x ^= (x & 0xaaaaaaaau) >> 1;
    x ^= (x & 0xccccccccu) >> 2;
    x ^= (x & 0xf0f0f0f0u) >> 4;
    x ^= (x & 0xff00ff00u) >> 8;
    return x ^ ((x & 0xffff0000u) >> 16);
}

/// Point i of a (0,2)-sequence in base 2, scrambled and shuffled by key and dimension.
///
/// Source: Sobol', USSR Comp. Math. 7(4), 1967; Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
[[gnu::always_inline]] inline vec2 sobol_2d(Bits key, std::uint32_t i, Bits dimension) {
    const Bits seeds = combine(key, dimension), more = mix(seeds);
    const std::uint32_t shuffled = reversed(scrambled(reversed(i), std::uint32_t(more)));
    const std::uint32_t x = reversed(scrambled(shuffled, std::uint32_t(seeds)));
    const std::uint32_t y = reversed(scrambled(pascal(shuffled), std::uint32_t(seeds >> 32)));
    return {x * 0x1p-32, y * 0x1p-32};
}

/// Where i, 0 <= i < n, goes in a permutation of n that the key chooses.
///
/// A bijection of the next power of two, repeated until it falls below n.
inline int permuted(int i, int n, Bits key) {
    const std::uint32_t mask = std::bit_ceil(std::uint32_t(n)) - 1;
    const int half = (std::bit_width(mask) + 1) / 2;
    const std::uint32_t a = std::uint32_t(key), b = std::uint32_t(key >> 32);
    std::uint32_t x = std::uint32_t(i);
    do {
        x = (x + a) & mask;
        x = (x * (b | 1)) & mask;
        x ^= x >> half;
        x = (x * ((a >> 7) | 1)) & mask;
        x = (x + (b >> 9)) & mask;
        x ^= x >> half;
        x = (x * 0x2c1b3c6du) & mask;
        x ^= x >> half;
        x = (x * ((b >> 17) | 1)) & mask;
    } while (x >= std::uint32_t(n));
    return int(x);
}

/// Sample i of n in one 2D dimension of a sampling pattern.
///
///     uniform     the middle of each cell; every pixel and seed has the same
///     random      independent
///     stratified  a random point in each cell
///     sobol       Owen-scrambled (0,2)-sequence
///
/// Cells are dealt out in another random order in each dimension: dimensions must not go together.
template <Sampler sampler>
[[gnu::always_inline]] inline vec2 pattern_2d(Bits key, int i, int n, Bits dimension) {
    if constexpr (sampler == Sampler::random) return random_2d(key, Bits(i), dimension);
    if constexpr (sampler == Sampler::sobol) return sobol_2d(key, std::uint32_t(i), dimension);
    if constexpr (sampler == Sampler::stratified)
        return stratified_2d(permuted(i, n, combine(~key, dimension)), n, random_2d(key, Bits(i), dimension));
    return stratified_2d(permuted(i, n, combine(0, dimension)), n, vec2(0.5));
}

template <Sampler sampler>
[[gnu::always_inline]] inline Real pattern_1d(Bits key, int i, int n, Bits dimension) {
    if constexpr (sampler == Sampler::random) return random_1d(key, Bits(i), dimension);
    if constexpr (sampler == Sampler::sobol) return sobol_2d(key, std::uint32_t(i), dimension).x;
    if constexpr (sampler == Sampler::stratified)
        return std::min((permuted(i, n, combine(~key, dimension)) + random_1d(key, Bits(i), dimension)) / n, below_one);
    return (permuted(i, n, combine(0, dimension)) + 0.5) / n;
}

}  // namespace rt
