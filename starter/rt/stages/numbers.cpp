#include <algorithm>

#include "rt/stages/stages.h"

namespace rt {
namespace {

/// Calls f with the sampler as a compile-time constant.
template <class F>
auto with_sampler(Sampler sampler, F f) {
    switch (sampler) {
        case Sampler::uniform:
            return f(std::integral_constant<Sampler, Sampler::uniform>{});
        case Sampler::random:
            return f(std::integral_constant<Sampler, Sampler::random>{});
        case Sampler::stratified:
            return f(std::integral_constant<Sampler, Sampler::stratified>{});
        case Sampler::blue_noise:
            return f(std::integral_constant<Sampler, Sampler::blue_noise>{});
        case Sampler::orthogonal:
            return f(std::integral_constant<Sampler, Sampler::orthogonal>{});
        default:
            return f(std::integral_constant<Sampler, Sampler::sobol>{});
    }
}

/// Whether all lanes have one key, as the samples of one pixel do: what is made of it is then made once.
bool is_one(const Bits* keys, int count) {
    Bits differ = 0;
    for (int i = 0; i < count; ++i) differ |= keys[i] ^ keys[0];
    return differ == 0;
}

template <Sampler sampler, bool one_key>
[[gnu::noinline]] void draw_pairs(int n, Dimension dimension, const Bits* keys, const int* samples, int count,
                                  Numbers& u) {
    const Bits first = keys[0];
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const vec2 point = pattern_2d<sampler>(one_key ? first : keys[i], samples[i], n, dimension);
        u.x[i] = point.x, u.y[i] = point.y;
    }
}

template <Sampler sampler>
[[gnu::noinline]] void draw_singles(int n, Dimension dimension, const Bits* keys, const int* samples, int count,
                                    Numbers& u) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) u.x[i] = pattern_1d<sampler>(keys[i], samples[i], n, dimension);
}

/// Whether lanes have the samples of pixels in order, those of a multiple of 64 and on, or all n.
bool is_in_order(const int* samples, int count, int n) {
    const int mask = std::min(n, lanes) - 1;
    int differ = samples[0] & mask;
    for (int i = 0; i < count; ++i) differ |= samples[i] ^ (samples[0] + (i & mask));
    return differ == 0;
}

template <bool one_key, bool pairs>
[[gnu::noinline]] void draw_in_order(const LaneDigits& of_lanes, Digits of_first, Bits number, const Bits* keys,
                                     int count, Numbers& u) {
    const Bits seeds = combine(keys[0], number);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const Digits digits{of_lanes.x[i] ^ of_first.x, of_lanes.y[i] ^ of_first.y};
        const vec2 point = scrambled_point(digits, one_key ? seeds : combine(keys[i], number));
        u.x[i] = point.x;
        if constexpr (pairs) u.y[i] = point.y;
    }
}

/// Whether the numbers could be drawn from the pattern's digits.
template <bool pairs>
bool draw_from_digits(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count,
                      Numbers& u) {
    if (!pattern.digits || dimension.column < 0 || dimension.round > 0) return false;
    if (!is_in_order(samples, count, pattern.n)) return false;
    const Digits first = samples[0] == 0 ? Digits{} : orthogonal_digits(0, samples[0], pattern.n, dimension);
    with_flag(is_one(keys, count), [&](auto one) {
        draw_in_order<one(), pairs>(pattern.digits[dimension.column], first, dimension.number, keys, count, u);
    });
    return true;
}

}  // namespace

std::vector<LaneDigits> digits_of_lanes(int n) {
    std::vector<LaneDigits> all(std::size_t(std::max(1, 1 << std::min(digit_bits(n), 4) >> 1)));
    for (std::size_t column = 0; column < all.size(); ++column)
        for (int i = 0; i < lanes; ++i) {
            const Digits digits = orthogonal_digits(0, i & (n - 1), n, Dimension(0, int(column), n));
            all[column].x[i] = digits.x, all[column].y[i] = digits.y;
        }
    return all;
}

void draw_2d(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count, Numbers& u) {
    if (draw_from_digits<true>(pattern, dimension, keys, samples, count, u)) return;
    with_sampler(pattern.sampler, [&](auto sampler) {
        with_flag(is_one(keys, count),
                  [&](auto one) { draw_pairs<sampler(), one()>(pattern.n, dimension, keys, samples, count, u); });
    });
}

void draw_1d(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count, Numbers& u) {
    if (draw_from_digits<false>(pattern, dimension, keys, samples, count, u)) return;
    with_sampler(pattern.sampler,
                 [&](auto sampler) { draw_singles<sampler()>(pattern.n, dimension, keys, samples, count, u); });
}

}  // namespace rt
