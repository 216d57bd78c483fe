#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "rt/answers.h"
#include "rt/scene.h"

/// Random numbers and sampling patterns. A number depends only on where it is used: the pixel's key, the sample's index
/// and the dimension. Nothing is stored, so any thread can draw any number.
namespace rt {

// Of fragments.h, which this file does not include: each new fragment would compile the whole framework again.
vec2 stratified_2d(int i, int n, vec2 u);

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

/// The bits of each byte in reverse order.
inline std::uint32_t reversed_bytes(std::uint32_t x) {
    x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
    return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

inline std::uint32_t reversed(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    return reversed_bytes(((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8));
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

/// The bits of x and y in turn: pixels that are close have numbers that are close.
///
/// Source: Morton, "A Computer Oriented Geodetic Data Base", IBM, 1966.
inline Bits interleaved(std::uint32_t x, std::uint32_t y) {
    Bits z = x | Bits(y) << 32;
    for (const int k : {8, 4, 2, 1}) {
        const Bits kept = k == 8   ? 0x00ff00ff00ff00ffu
                          : k == 4 ? 0x0f0f0f0f0f0f0f0fu
                          : k == 2 ? 0x3333333333333333u
                                   : 0x5555555555555555u;
        z = (z | z << k) & kept;
    }
    return (z & 0xffffffffu) | z >> 31;
}

/// The key of a pixel. Blue noise has one sequence for the picture: its key is the upper half, the lower one says which
/// samples of it are the pixel's.
inline Bits pixel_key(Bits seed, int width, int x, int y, Sampler sampler) {
    if (sampler == Sampler::blue_noise)
        return (combine(seed, 0) >> 32 << 32) | interleaved(std::uint32_t(x), std::uint32_t(y));
    return combine(seed, Bits(y) * Bits(width) + Bits(x));
}

/// The key of a path that leaves another one: of the same pixel, with numbers of its own.
inline Bits branch_key(Bits key, Sampler sampler) {
    if (sampler == Sampler::blue_noise) return (combine(key >> 32, 1) >> 32 << 32) | (key & 0xffffffffu);
    return combine(key, 1);
}

/// Sample i of n of a pixel, where all pixels have a part of one Sobol' sequence, in Morton's order: blocks of 2 x 2, 4
/// x 4, ... pixels share the points of a net, so that their errors cancel, and what is left is fine-grained noise.
///
/// Source: Ahmed and Wonka, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering
/// of Pixels", ACM TOG 39(6), 2020.
[[gnu::always_inline]] inline vec2 blue_noise_2d(Bits key, int i, int n, Bits dimension) {
    return sobol_2d(key >> 32, std::uint32_t(key) * std::bit_ceil(std::uint32_t(n)) + std::uint32_t(i), dimension);
}

/// A 2D dimension of a sampling pattern.
struct Dimension {
    Bits number;        // of its random numbers
    Bits products = 0;  // of an orthogonal array: see field_products
    Bits round = 0;     // of an orthogonal array: 0 for the pairs of the first one
    int column = -1;    // of an orthogonal array: which pair of it

    constexpr Dimension(Bits number) : number(number) {}
    Dimension(Bits number, int pair, int n);  // the pair-th of those that are drawn, for n samples
};

/// Products with one element of the field of 2^h elements, h <= 4: byte k is the product with x^k.
constexpr Bits field_products(int h, Bits element) {
    constexpr Bits polynomials[] = {1, 0x3, 0x7, 0xb, 0x13};  // irreducible
    Bits products = 0;
    for (int k = 0; k < h; ++k) {
        products |= element << (8 * k);
        element <<= 1;
        if (element >> h) element ^= polynomials[h];
    }
    return products;
}

/// An orthogonal array of n = 4^h <= 256 samples has two digits of h bits for each dimension; see pattern_of.
inline int digit_bits(int n) { return std::bit_width(unsigned(n - 1)) / 2; }

inline Dimension::Dimension(Bits number, int pair, int n) : number(number) {
    if (pair < 0) return;
    const int h = std::min(digit_bits(n), 4), pairs = h > 0 ? 1 << (h - 1) : 1;
    column = pair % pairs;
    products = field_products(h, Bits(2 * column));
    round = Bits(pair / pairs);
}

/// A bijection of m bits.
inline std::uint32_t mixed(std::uint32_t i, int m, std::uint32_t key) {
    i = (i * (key | 1) + (key >> 16)) & ((1u << m) - 1);
    return i ^ (i >> ((m + 1) / 2));
}

/// A point of an orthogonal array before it is scrambled: its binary digits, the leading one the lowest.
struct Digits {
    std::uint32_t x = 0, y = 0;
};

/// Sample i of n in one pair of the dimensions of an orthogonal array of strength 2.
///
/// n = 4^h. In the field of 2^h elements, sample (a, b) has the leading digits u = b + c a and
/// v = u + a, with another c for each pair: any two dimensions of two pairs have one sample in each of 2^h x 2^h cells.
/// The second digits are those of the other dimension of the pair, turned round, which makes each pair a
/// (0,2h,2)-net. There are 2^(h-1) pairs; those that follow take the samples in another order.
///
/// In the first round all this is linear: the digits of i ^ j are those of i ^ those of j.
///
/// Source: Bose, "On the Application of the Properties of Galois Fields to the Problem of Construction of
/// Hyper-Graeco-Latin Squares", Sankhya 3(4), 1938; Jarosz et al., "Orthogonal Array Sampling for Monte Carlo
/// Rendering", EGSR 2019.
[[gnu::always_inline]] inline Digits orthogonal_digits(Bits key, int sample, int n, Dimension dimension) {
    const int h = digit_bits(n), m = 2 * h;
    std::uint32_t i = std::uint32_t(sample);
    if (dimension.round > 0) {
        const Bits order = combine(~key, dimension.round);
        i = mixed(mixed(mixed(i, m, std::uint32_t(order)), m, std::uint32_t(order >> 16)), m,
                  std::uint32_t(order >> 32));
    }
    const std::uint32_t a = i >> h;
    std::uint32_t u = i & ((1u << h) - 1);
    for (int k = 0; k < 4; ++k) u ^= std::uint32_t(dimension.products >> (8 * k)) & 0xff & (0u - (a >> k & 1));
    const std::uint32_t v = u ^ a;
    const std::uint32_t turned = reversed_bytes(u | v << 16);
    return {u | turned >> 16 >> (8 - h) << h, v | (turned & 0xff) >> (8 - h) << h};
}

/// The point of these digits, scrambled; one seed for each dimension.
[[gnu::always_inline]] inline vec2 scrambled_point(Digits digits, Bits seeds) {
    const std::uint32_t x = reversed(scrambled(digits.x, std::uint32_t(seeds)));
    const std::uint32_t y = reversed(scrambled(digits.y, std::uint32_t(seeds >> 32)));
    return {x * 0x1p-32, y * 0x1p-32};
}

[[gnu::always_inline]] inline vec2 orthogonal_2d(Bits key, int sample, int n, Dimension dimension) {
    return scrambled_point(orthogonal_digits(key, sample, n, dimension), combine(key, dimension.number));
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
///     orthogonal  scrambled orthogonal array: even between dimensions too; sobol where n is no power of four to 256
///     blue_noise  one (0,2)-sequence for all pixels: neighbours err in opposite directions
///
/// Cells are dealt out in another random order in each dimension: dimensions must not go together.
template <Sampler sampler>
[[gnu::always_inline]] inline vec2 pattern_2d(Bits key, int i, int n, Dimension dimension) {
    if constexpr (sampler == Sampler::random) return random_2d(key, Bits(i), dimension.number);
    if constexpr (sampler == Sampler::sobol) return sobol_2d(key, std::uint32_t(i), dimension.number);
    if constexpr (sampler == Sampler::orthogonal) return orthogonal_2d(key, i, n, dimension);
    if constexpr (sampler == Sampler::blue_noise) return blue_noise_2d(key, i, n, dimension.number);
    if constexpr (sampler == Sampler::stratified)
        return stratified_2d(permuted(i, n, combine(~key, dimension.number)), n,
                             random_2d(key, Bits(i), dimension.number));
    return stratified_2d(permuted(i, n, combine(0, dimension.number)), n, vec2(0.5));
}

template <Sampler sampler>
[[gnu::always_inline]] inline Real pattern_1d(Bits key, int i, int n, Dimension dimension) {
    if constexpr (sampler == Sampler::random) return random_1d(key, Bits(i), dimension.number);
    if constexpr (sampler == Sampler::sobol) return sobol_2d(key, std::uint32_t(i), dimension.number).x;
    if constexpr (sampler == Sampler::orthogonal) return orthogonal_2d(key, i, n, dimension).x;
    if constexpr (sampler == Sampler::blue_noise) return blue_noise_2d(key, i, n, dimension.number).x;
    if constexpr (sampler == Sampler::stratified)
        return std::min(
            (permuted(i, n, combine(~key, dimension.number)) + random_1d(key, Bits(i), dimension.number)) / n,
            below_one);
    return (permuted(i, n, combine(0, dimension.number)) + 0.5) / n;
}

/// The pattern that takes n samples. An orthogonal array has a power of four, at most 256: with more, what three
/// dimensions do together is left, while Sobol's points go on to improve.
inline Sampler pattern_of(Sampler sampler, int n) {
    const bool fits = std::has_single_bit(unsigned(n)) && std::countr_zero(unsigned(n)) % 2 == 0 && n <= 256;
    return sampler == Sampler::orthogonal && !fits ? Sampler::sobol : sampler;
}

}  // namespace rt
