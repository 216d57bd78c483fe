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

}  // namespace

void draw_2d(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count, Numbers& u) {
    with_sampler(pattern.sampler, [&](auto sampler) {
        with_flag(is_one(keys, count),
                  [&](auto one) { draw_pairs<sampler(), one()>(pattern.n, dimension, keys, samples, count, u); });
    });
}

void draw_1d(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count, Numbers& u) {
    with_sampler(pattern.sampler,
                 [&](auto sampler) { draw_singles<sampler()>(pattern.n, dimension, keys, samples, count, u); });
}

}  // namespace rt
