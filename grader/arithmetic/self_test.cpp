#include "arithmetic/self_test.h"

#include <limits>

namespace grade {

namespace {

/// A number that the compiler knows nothing about.
double opaque(double x) {
    volatile double hidden = x;
    return hidden;
}

/// Vectors are contracted and reordered where single numbers are not: a loop of its own for each question.
constexpr int count = 16;

bool contracts() {
    double a[count], b[count], c[count];
    for (int i = 0; i < count; ++i) a[i] = opaque(1 + 0x1p-30), b[i] = opaque(1 - 0x1p-30), c[i] = opaque(-1);
    bool fused = false;
    for (int i = 0; i < count; ++i) fused |= a[i] * b[i] + c[i] != 0;  // 1 - 2^-60 is rounded to 1
    return fused;
}

bool reorders() {
    double sum = 0;
    for (const double term : {1e16, 1.0, -1e16, 1.0}) sum += opaque(term);
    const double big = opaque(1e16), one = opaque(1);
    return sum != 1 || (big + one) - big != 0 || opaque(5) * (one / opaque(49)) == opaque(5) / opaque(49);
}

bool ignores_special_values() {
    const double nan = opaque(std::numeric_limits<double>::quiet_NaN()), zero = opaque(0), huge = opaque(1e308);
    const bool nan_is_equal = nan == nan, zero_has_no_sign = 1 / (zero * -1) > 0, finite = huge * 10 - huge * 10 == 0;
    return nan_is_equal || zero_has_no_sign || finite;
}

bool flushes_denormals() {
    const double least = opaque(std::numeric_limits<double>::min()), half = least / 2;
    return opaque(half) == 0 || opaque(half) * 2 != least;
}

bool rounds_otherwise() {
    return opaque(1) + opaque(0x1p-53) != 1 || opaque(-1) - opaque(0x1p-53) != -1 || opaque(1) + opaque(0x1.8p-53) == 1;
}

}  // namespace

std::string arithmetic_fault() {
    if (flushes_denormals())
        return "denormal numbers are flushed to zero (-ffast-math at the link, or a library, sets this)";
    if (ignores_special_values())
        return "nan, infinity or the sign of zero is ignored (-ffast-math or -ffinite-math-only)";
    if (reorders()) return "sums are reordered or divisions replaced (-ffast-math or -funsafe-math-optimizations)";
    if (contracts()) return "products and sums are fused (-ffp-contract=fast)";
    if (rounds_otherwise()) return "the rounding mode is not to nearest";
    return {};
}

}  // namespace grade
