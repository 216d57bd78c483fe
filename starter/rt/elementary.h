#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "rt/math.h"

/// Exponential, logarithm and arc tangent without library calls: loops over them vectorise, and every machine and
/// compiler gets the same bits. Errors below 2 units in the last place, of the arc tangent below 3.
///
/// Source: Muller, "Elementary Functions: Algorithms and Implementation", 3rd ed., 2016, chapters 3 and 11.
namespace rt {
namespace elementary {

// ln 2 in two parts; the first has few enough digits for its product with an exponent to be exact.
constexpr Real ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;

/// 2^k of a whole number k, -1022 <= k <= 1023.
[[gnu::always_inline]] inline Real power_of_two(Real k) {
    // a large addend puts the number into the low bits
    return std::bit_cast<Real>(std::bit_cast<std::uint64_t>(k + (0x1.8p52 + 1023)) << 52);
}

struct Reduced {
    Real k, low;  // e^x = 2^k (1 + low), x = k ln 2 + r, |r| <= ln 2 / 2
};

[[gnu::always_inline]] inline Reduced reduced(Real x) {
    const Real k = std::floor(x * 0x1.71547652b82fep0 + 0.5);
    const Real r = (x - k * ln2_high) - k * ln2_low;
    Real sum = 1.0 / 6227020800;
    sum = sum * r + 1.0 / 479001600;
    sum = sum * r + 1.0 / 39916800;
    sum = sum * r + 1.0 / 3628800;
    sum = sum * r + 1.0 / 362880;
    sum = sum * r + 1.0 / 40320;
    sum = sum * r + 1.0 / 5040;
    sum = sum * r + 1.0 / 720;
    sum = sum * r + 1.0 / 120;
    sum = sum * r + 1.0 / 24;
    sum = sum * r + 1.0 / 6;
    sum = sum * r + 0.5;
    return {k, r + r * r * sum};
}

}  // namespace elementary

/// e^x.
[[gnu::always_inline]] inline Real exp(Real x) {
    const Real clamped = x > 710 ? 710 : x > -746 ? x : -746;
    const elementary::Reduced e = elementary::reduced(clamped);
    // in two steps, for one alone may leave the range
    const Real half = std::floor(0.5 * e.k);
    const Real first = elementary::power_of_two(half), second = elementary::power_of_two(e.k - half);
    const Real value = (first + first * e.low) * second;
    return x == x ? value : x;
}

/// e^x - 1, with all its digits for a small x.
[[gnu::always_inline]] inline Real expm1(Real x) {
    const Real clamped = x > 710 ? 710 : x > -700 ? x : -700;
    const elementary::Reduced e = elementary::reduced(clamped);
    const Real half = elementary::power_of_two(e.k - 1);  // 2^1024 is no number
    const Real value = 2 * (half * e.low + (half - 0.5));
    return x == x ? value : x;
}

/// The natural logarithm; -inf for 0, NaN for less.
[[gnu::always_inline]] inline Real log(Real x) {
    // x = 2^e (1 + f), 1 + f between sqrt(1/2) and sqrt(2)
    const bool tiny = x < 0x1p-1022;
    const std::uint64_t root = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(tiny ? x * 0x1p54 : x) + (one - root);
    const Real e = std::bit_cast<Real>((bits >> 52) | 0x4330000000000000) - (0x1p52 + (tiny ? 1077 : 1023));
    const Real f = std::bit_cast<Real>((bits & 0x000fffffffffffff) + root) - 1;
    // log(1 + f) = 2 artanh(s) = f - s (f - sum), s = f / (2 + f)
    const Real s = f / (2 + f), s2 = s * s;
    Real sum = 2.0 / 23;
    sum = sum * s2 + 2.0 / 21;
    sum = sum * s2 + 2.0 / 19;
    sum = sum * s2 + 2.0 / 17;
    sum = sum * s2 + 2.0 / 15;
    sum = sum * s2 + 2.0 / 13;
    sum = sum * s2 + 2.0 / 11;
    sum = sum * s2 + 2.0 / 9;
    sum = sum * s2 + 2.0 / 7;
    sum = sum * s2 + 2.0 / 5;
    sum = sum * s2 + 2.0 / 3;
    const Real value = e * elementary::ln2_high + (f - (s * (f - s2 * sum) - e * elementary::ln2_low));
    const Real finite = x < inf ? value : x;
    return x > 0 ? finite : x == 0 ? -inf : std::numeric_limits<Real>::quiet_NaN();
}

/// log(1 + x), with all its digits for a small x.
[[gnu::always_inline]] inline Real log1p(Real x) {
    const Real sum = 1 + x;
    const Real lost = x - (sum - 1);  // by the rounding of the sum
    const Real value = log(sum) + lost / sum;
    const Real above = sum > 0 && sum < inf ? value : log(sum);
    return sum == 1 ? x : above;
}

/// The angle of a vector from the x axis, -pi to pi [rad].
[[gnu::always_inline]] inline Real angle_of(vec2 v) {
    const Real ax = std::abs(v.x), ay = std::abs(v.y);
    const bool steep = ay > ax;
    const Real ratio = steep ? ax / ay : ay / ax;  // 0 to 1
    // from the diagonal, where that is nearer: tan(a - pi/4) = (tan a - 1) / (tan a + 1)
    const bool diagonal = ratio > 0x1.a827999fcef32p-2;  // tan(pi/8)
    const Real t = diagonal ? (ratio - 1) / (ratio + 1) : ratio, t2 = t * t;
    Real sum = 1.0 / 45;
    sum = 1.0 / 43 - sum * t2;
    sum = 1.0 / 41 - sum * t2;
    sum = 1.0 / 39 - sum * t2;
    sum = 1.0 / 37 - sum * t2;
    sum = 1.0 / 35 - sum * t2;
    sum = 1.0 / 33 - sum * t2;
    sum = 1.0 / 31 - sum * t2;
    sum = 1.0 / 29 - sum * t2;
    sum = 1.0 / 27 - sum * t2;
    sum = 1.0 / 25 - sum * t2;
    sum = 1.0 / 23 - sum * t2;
    sum = 1.0 / 21 - sum * t2;
    sum = 1.0 / 19 - sum * t2;
    sum = 1.0 / 17 - sum * t2;
    sum = 1.0 / 15 - sum * t2;
    sum = 1.0 / 13 - sum * t2;
    sum = 1.0 / 11 - sum * t2;
    sum = 1.0 / 9 - sum * t2;
    sum = 1.0 / 7 - sum * t2;
    sum = 1.0 / 5 - sum * t2;
    sum = 1.0 / 3 - sum * t2;
    const Real octant = t - t * t2 * sum;
    const Real acute = diagonal ? pi / 4 + octant : octant;
    const Real upper = steep ? pi / 2 - acute : acute;
    const Real left = v.x < 0 ? pi - upper : upper;
    return v.y < 0 ? -left : left;
}

}  // namespace rt
