#pragma once

#include <cstring>

#include "rt/batch.h"
#include "rt/tree/bvh.h"

namespace rt {

/// What the rays of a batch have in common: boxes about their origins and directions, and where they begin. A shape
/// that no such ray can meet need not be tried.
///
/// Source: Boulos, Wald, Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", University of
/// Utah, UUCS-06-10, 2006.
struct Shaft {
    Box origins, directions;
    Real near = inf;

    bool empty() const { return near == inf; }
};

/// The shaft of all rays with near < far; empty where there is none.
inline Shaft shaft_of(const Batch& b) {
    // Several lanes in one number, an extension of GCC and Clang: no compiler vectorises a minimum by itself.
    constexpr int width = 8;
    using Reals __attribute__((vector_size(width * sizeof(Real)))) = Real;
    const Reals none = Reals{} + inf;
    const Real* from[7] = {b.origin.x, b.origin.y, b.origin.z, b.direction.x, b.direction.y, b.direction.z, b.near};
    Reals low[7], high[7];
    for (int a = 0; a < 7; ++a) low[a] = none, high[a] = -none;
    for (int i = 0; i < lanes; i += width) {
        Reals x, far;
        std::memcpy(&x, b.near + i, sizeof x);
        std::memcpy(&far, b.far + i, sizeof far);
        const auto on = x < far;
        for (int a = 0; a < 7; ++a) {
            std::memcpy(&x, from[a] + i, sizeof x);
            const Reals least = on ? x : none, most = on ? x : -none;
            low[a] = least < low[a] ? least : low[a];
            high[a] = most > high[a] ? most : high[a];
        }
    }
    Shaft shaft;
    for (int j = 0; j < width; ++j) {
        shaft.near = std::min(shaft.near, low[6][j]);
        shaft.origins.include(Box{vec3(low[0][j], low[1][j], low[2][j]), vec3(high[0][j], high[1][j], high[2][j])});
        shaft.directions.include(Box{vec3(low[3][j], low[4][j], low[5][j]), vec3(high[3][j], high[4][j], high[5][j])});
    }
    return shaft;
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
