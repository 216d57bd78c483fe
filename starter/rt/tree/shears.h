#pragma once

#include "rt/tree/beam.h"

/// Which rays of a beam surely pass a triangle by, in single precision, as many at once as a register holds. A beam
/// meets the boxes of several triangles for each that its rays hit; only of what is left is hit_triangle asked.
/// Nobody needs this folder for the assignment.
namespace rt {

/// The rays in the tree's space, where they run mostly along one axis: as points of the plane of the two others, which
/// move as a point goes along.
struct alignas(64) Shears {
    int axis = none;        // none: there is no such axis, and no ray is left out
    float slope[2][lanes];  // along the next axis and the one after it, per unit along this one, at most 1 / least_part
    float at_zero[2][lanes];  // where the ray is at 0 of the axis
    float error[lanes];       // of a corner's distance from the ray

    static constexpr int none = 3;
    static constexpr float least_part = 0.25f;
};

/// A triangle in the tree's space.
struct Corners {
    float a[3], b[3], c[3];
};

inline Corners corners_of(const Triangle& t, const Bvh& bvh) {
    Corners corners;
    for (int axis = 0; axis < 3; ++axis) {
        corners.a[axis] = float((t.a[axis] - bvh.center[axis]) * bvh.scale);
        corners.b[axis] = float((t.b[axis] - bvh.center[axis]) * bvh.scale);
        corners.c[axis] = float((t.c[axis] - bvh.center[axis]) * bvh.scale);
    }
    return corners;
}

/// Roundings: with parts of 1/4 to 1 and coordinates up to 1, those of a slope, of where a ray is at 0 and of a corner
/// are 53 units of 2^-24 together, a third of 5 box_margin; what is uncertain about a ray in double precision, which is
/// in its margin too, counts once along each axis across, and up to 4 times along this one.
inline void start(const Journeys& j, const Beam& beam, Shears& shears) {
    shears.axis = Shears::none;
    float least = Shears::least_part;
    for (int a = 0; a < 3; ++a) {
        if (beam.runs[a] == Beam::Runs::both) continue;
        const float part = 1 / std::max(std::abs(beam.over_least[a]), std::abs(beam.over_greatest[a]));
        if (part >= least) shears.axis = a, least = part;
    }
    if (shears.axis == Shears::none) return;
    const float *const part = j.part[shears.axis], *const inside = j.inside[shears.axis];
    for (int k = 0; k < 2; ++k) {
        const int across = (shears.axis + 1 + k) % 3;
        for (int i = 0; i < lanes; ++i) {
            shears.slope[k][i] = j.part[across][i] / part[i];
            shears.at_zero[k][i] = j.inside[across][i] - shears.slope[k][i] * inside[i];
        }
    }
    for (int i = 0; i < lanes; ++i) shears.error[i] = 5 * j.margin[i];
}

/// Without the rays that pass the triangle by: on the outer side of one edge and the inner side of another, by more
/// than all roundings.
///
/// With each coordinate of p and q off by e, p x q is off by at most e (|p| + |q|) + 2 e^2; its own roundings are less
/// than half of that where coordinates are at most 20.
inline std::uint64_t may_hit(const Corners& corners, const Shears& shears, std::uint64_t rays) {
    const int z = shears.axis, x = (z + 1) % 3, y = (z + 2) % 3;
    std::uint64_t left = 0;
    for (int i = 0; i < lanes; i += wide) {
        if ((rays >> i & ((std::uint64_t(1) << wide) - 1)) == 0) continue;
        const Floats slope_x = load<Floats>(shears.slope[0] + i), slope_y = load<Floats>(shears.slope[1] + i),
                     at_x = load<Floats>(shears.at_zero[0] + i), at_y = load<Floats>(shears.at_zero[1] + i);
        const Floats ax = corners.a[x] - at_x - slope_x * corners.a[z],
                     ay = corners.a[y] - at_y - slope_y * corners.a[z],
                     bx = corners.b[x] - at_x - slope_x * corners.b[z],
                     by = corners.b[y] - at_y - slope_y * corners.b[z],
                     cx = corners.c[x] - at_x - slope_x * corners.c[z],
                     cy = corners.c[y] - at_y - slope_y * corners.c[z];
        const Floats u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
        const auto size = [](Floats f) { return greater(f, -f); };
        const Floats e = load<Floats>(shears.error + i);
        const Floats off = 2 * e * (size(ax) + size(ay) + size(bx) + size(by) + size(cx) + size(cy) + e);
        const Floats least = lesser(u, lesser(v, w)), greatest = greater(u, greater(v, w));
        left |= std::uint64_t(not_above(-off, least) | not_above(greatest, off)) << i;
    }
    return left & rays;
}

}  // namespace rt
