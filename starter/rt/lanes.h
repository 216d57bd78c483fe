#pragma once

#include <cstdint>

#include "rt/math.h"

/// Lanes side by side, so that a loop over them becomes vectors: one instruction for up to eight lanes. What a compiler
/// asks of such a loop, and why the code about it looks as it does:
///
///     #pragma GCC ivdep    no lane depends on another: any order will do. tests/vectorised_test.py asks GCC whether
///                          each loop that is marked so is vectorised
///     for all `lanes`      also those that are not in use: the length is known, and no lane is left over
///     arrays of numbers    a loop that copies structures stays scalar. Hence Vectors, and `?:` by coordinate
///     alignas(64)          eight numbers are one line of the cache
///     noinline             the compiler gives up on loops in a large function; those that matter have one of their own
///     always_inline        nor does it vectorise a loop with a call; what it does for one lane becomes part of it
///     x = x_in_memory      a copy of what all lanes share stays in registers: nothing that the loop writes changes it
///     `|`, `&` of bools    `||` and `&&` are branches
namespace rt {

constexpr int lanes = 64;
using Index = std::int64_t;  // as wide as a Real, so that loops over both need no conversion

/// A vector or a colour for each of n lanes.
template <int n = lanes>
struct alignas(64) Vectors {
    Real x[n], y[n], z[n];

    vec3 at(int i) const { return {x[i], y[i], z[i]}; }
    void set(int i, vec3 v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};
using Colors = Vectors<>;

}  // namespace rt
