#pragma once

#include <cstring>

#include "rt/batch.h"
#include "rt/tree/bvh.h"

namespace rt {

/// What the rays of a batch have in common: boxes about their origins and directions, and where they begin. A shape
/// that no such ray can meet need not be tried. Nobody needs this file for the assignment.
///
/// Source: Boulos, Wald, Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", University of
/// Utah, UUCS-06-10, 2006.
struct Shaft {
    Box origins, directions;
    Real near = inf;

    bool empty() const { return near == inf; }
};

// Several lanes in one number, an extension of GCC and Clang: no compiler vectorises a minimum by itself.
using Reals __attribute__((vector_size(8 * sizeof(Real)))) = Real;

inline void lower(Reals& least, const Reals& x) { least = x < least ? x : least; }
inline void raise(Reals& most, const Reals& x) { most = x > most ? x : most; }

/// The least or the greatest of the eight.
template <class F>
Real folded(Reals& x, F lower_or_raise) {
    lower_or_raise(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
    lower_or_raise(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
    lower_or_raise(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
    return x[0];
}

/// all  whether near < far everywhere
template <bool all>
Shaft shaft_about(const Batch& b) {
    const Reals none = Reals{} + inf;
    const Real* from[7] = {b.origin.x, b.origin.y, b.origin.z, b.direction.x, b.direction.y, b.direction.z, b.near};
    Reals low[7], high[7];
    for (int a = 0; a < 7; ++a) low[a] = none, high[a] = -none;
    for (int i = 0; i < lanes; i += 8) {
        Reals x, far;
        std::memcpy(&x, b.near + i, sizeof x);
        std::memcpy(&far, b.far + i, sizeof far);
        const auto on = x < far;
        for (int a = 0; a < 7; ++a) {
            std::memcpy(&x, from[a] + i, sizeof x);
            lower(low[a], all ? x : on ? x : none);
            raise(high[a], all ? x : on ? x : -none);
        }
    }
    const auto corner = [](Reals* x, auto f) { return vec3(folded(x[0], f), folded(x[1], f), folded(x[2], f)); };
    return {{corner(low, lower), corner(high, raise)},
            {corner(low + 3, lower), corner(high + 3, raise)},
            folded(low[6], lower)};
}

/// The shaft of all rays with near < far; empty where there is none.
inline Shaft shaft_of(const Batch& b) {
    Index off = 0;
    for (int i = 0; i < lanes; ++i) off |= !(b.near[i] < b.far[i]);
    return off == 0 ? shaft_about<true>(b) : shaft_about<false>(b);
}

/// Whether a ray of the shaft may meet the box; false only where none can, with all roundings.
///
/// Along each axis origin + t direction must be in the box for some ray; the t of all axes must have one in common.
inline bool may_meet(const Shaft& shaft, const Box& box) {
    Real first = (1 - 0x1p-20) * shaft.near, last = inf;
    for (int a = 0; a < 3; ++a) {
        const Real reach = std::max(std::max(std::abs(shaft.origins.low[a]), std::abs(shaft.origins.high[a])),
                                    std::max(std::abs(box.low[a]), std::abs(box.high[a])));
        const Real margin = 64 * roundoff * reach;
        const Real low = box.low[a] - shaft.origins.high[a] - margin,
                   high = box.high[a] - shaft.origins.low[a] + margin;
        const Real slow = shaft.directions.low[a], fast = shaft.directions.high[a];
        // t slow <= high and t fast >= low, t >= 0
        if (slow > 0) last = std::min(last, high / slow);
        if (slow < 0) first = std::max(first, high / slow);
        if (slow == 0 && high < 0) return false;
        if (fast > 0) first = std::max(first, low / fast);
        if (fast < 0) last = std::min(last, low / fast);
        if (fast == 0 && low > 0) return false;
    }
    return first <= last;
}

}  // namespace rt
