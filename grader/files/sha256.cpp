#include "files/sha256.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace grade {

namespace {

using State = std::array<std::uint32_t, 8>;

/// The first 32 bits of the fraction.
std::uint32_t fraction(double x) { return std::uint32_t((x - std::floor(x)) * 4294967296.0); }

/// Fractions of the square roots (2) or cube roots (3) of the first primes.
template <std::size_t count>
std::array<std::uint32_t, count> roots_of_primes(int degree) {
    std::array<std::uint32_t, count> all{};
    std::size_t have = 0;
    for (unsigned n = 2; have < count; ++n) {
        bool is_prime = true;
        for (unsigned d = 2; d * d <= n; ++d) is_prime &= n % d != 0;
        if (is_prime) all[have++] = fraction(degree == 2 ? std::sqrt(n) : std::cbrt(n));
    }
    return all;
}

void add_block(State& state, const unsigned char* block) {
    static const auto k = roots_of_primes<64>(3);
    std::array<std::uint32_t, 64> w;
    for (std::size_t i = 0; i < 16; ++i)
        w[i] = std::uint32_t(block[4 * i]) << 24 | std::uint32_t(block[4 * i + 1]) << 16 |
               std::uint32_t(block[4 * i + 2]) << 8 | block[4 * i + 3];
    for (std::size_t i = 16; i < 64; ++i) {
        const std::uint32_t a = w[i - 15], b = w[i - 2];
        w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) + w[i - 7] +
               (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
        const std::uint32_t one =
            h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + k[i] + w[i];
        const std::uint32_t two =
            (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
    }
    const State sum{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i) state[i] += sum[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
    static const State start = roots_of_primes<8>(2);
    State state = start;
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    std::size_t done = 0;
    for (; bytes.size() - done >= 64; done += 64) add_block(state, data + done);
    // the rest, a 1, zeros, and the length in bits
    std::string tail(bytes.substr(done));
    tail += '\x80';
    while (tail.size() % 64 != 56) tail += '\0';
    for (int shift = 56; shift >= 0; shift -= 8) tail += char(std::uint64_t(bytes.size()) * 8 >> shift & 0xff);
    for (std::size_t at = 0; at < tail.size(); at += 64)
        add_block(state, reinterpret_cast<const unsigned char*>(tail.data()) + at);
    std::string text;
    for (const std::uint32_t word : state) text += fmt::format("{:08x}", word);
    return text;
}

}  // namespace grade
