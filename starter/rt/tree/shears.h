#pragma once

#include "rt/tree/beam.h"

/// Which rays surely pass a triangle by, in single precision: of a beam, as many rays at once as a register holds; or
/// one ray, and all triangles of a leaf. Rays meet the boxes of several triangles for each that they hit; only of what
/// is left is hit_triangle asked. Nobody needs this folder for the assignment.
namespace rt {

/// The rays in the tree's space, where they run mostly along one axis: as points of the plane of the two others, which
/// move as a point goes along.
struct alignas(64) Shears {
    std::int32_t axis[lanes];
    float slope[2][lanes];  // along the next axis and the one after it, per unit along this one, at most 1 / least_part
    float at_zero[2][lanes];  // where the ray is at 0 of the axis
    float error[lanes];       // of a corner's distance from the ray

    static constexpr float least_part = 0.25f;
};

/// Each ray runs along its own axis, the one of its largest part.
///
/// Roundings: with parts of 1/4 to 1 and coordinates up to 1, those of a slope, of where a ray is at 0 and of a corner
/// are 53 units of 2^-24 together, a third of 5 box_margin; what is uncertain about a ray in double precision, which is
/// in its margin too, counts once along each axis across, and up to 4 times along this one.
inline void start(const Journeys& j, Shears& shears) {
    for (int i = 0; i < lanes; ++i) {
        const float part[3] = {j.part[0][i], j.part[1][i], j.part[2][i]};
        const float x = std::abs(part[0]), y = std::abs(part[1]), z = std::abs(part[2]);
        const bool along_x = x >= y && x >= z, along_y = !along_x && y >= z;
        shears.axis[i] = along_x ? 0 : along_y ? 1 : 2;
        const auto turned = [&](float of_x, float of_y, float of_z) { return along_x ? of_x : along_y ? of_y : of_z; };
        const float inside[3] = {j.inside[0][i], j.inside[1][i], j.inside[2][i]};
        const float over = 1 / turned(part[0], part[1], part[2]), at = turned(inside[0], inside[1], inside[2]);
        shears.slope[0][i] = turned(part[1], part[2], part[0]) * over;
        shears.slope[1][i] = turned(part[2], part[0], part[1]) * over;
        shears.at_zero[0][i] = turned(inside[1], inside[2], inside[0]) - shears.slope[0][i] * at;
        shears.at_zero[1][i] = turned(inside[2], inside[0], inside[1]) - shears.slope[1][i] * at;
        shears.error[i] = 5 * j.margin[i];
    }
}

/// All rays run along one axis. Returns whether there is such an axis.
inline bool start(const Journeys& j, const Beam& beam, Shears& shears) {
    int axis = -1;
    float least = Shears::least_part;
    for (int a = 0; a < 3; ++a) {
        if (beam.runs[a] == Beam::Runs::both) continue;
        const float part = 1 / std::max(std::abs(beam.over_least[a]), std::abs(beam.over_greatest[a]));
        if (part >= least) axis = a, least = part;
    }
    if (axis < 0) return false;
    const float *const part = j.part[axis], *const inside = j.inside[axis];
    for (int k = 0; k < 2; ++k) {
        const int across = (axis + 1 + k) % 3;
        for (int i = 0; i < lanes; ++i) {
            shears.slope[k][i] = j.part[across][i] / part[i];
            shears.at_zero[k][i] = j.inside[across][i] - shears.slope[k][i] * inside[i];
        }
    }
    for (int i = 0; i < lanes; ++i) shears.axis[i] = axis, shears.error[i] = 5 * j.margin[i];
    return true;
}

/// Bit k: the ray may hit triangle k, of which these are the corners in its plane, where the ray is 0. It does not
/// where that is on the outer side of one edge and the inner side of another, by more than all roundings.
///
/// With each coordinate of p and q off by e, p x q is off by at most e (|p| + |q|) + 2 e^2; its own roundings are less
/// than half of that where coordinates are at most 20.
template <class V>
[[gnu::always_inline]] inline unsigned may_hit(V ax, V ay, V bx, V by, V cx, V cy, V e) {
    const V u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    const auto size = [](V f) { return greater(f, -f); };
    const V off = 2 * e * (size(ax) + size(ay) + size(bx) + size(by) + size(cx) + size(cy) + e);
    const V least = lesser(u, lesser(v, w)), greatest = greater(u, greater(v, w));
    return not_above(-off, least) | not_above(greatest, off);
}

/// Those of the rays, which run along one axis, that may hit child c.
inline std::uint64_t may_hit(const Bvh::Corners& corners, int c, const Shears& shears, std::uint64_t rays) {
    const int z = shears.axis[0], x = (z + 1) % 3, y = (z + 2) % 3;
    const auto& at = corners.at;
    std::uint64_t left = 0;
    for (int i = 0; i < lanes; i += wide) {
        if ((rays >> i & ((std::uint64_t(1) << wide) - 1)) == 0) continue;
        const Floats slope_x = load<Floats>(shears.slope[0] + i), slope_y = load<Floats>(shears.slope[1] + i),
                     at_x = load<Floats>(shears.at_zero[0] + i), at_y = load<Floats>(shears.at_zero[1] + i);
        const auto x_of = [&](int v) { return at[v][x][c] - at_x - slope_x * at[v][z][c]; };
        const auto y_of = [&](int v) { return at[v][y][c] - at_y - slope_y * at[v][z][c]; };
        const Floats e = load<Floats>(shears.error + i);
        left |= std::uint64_t(may_hit<Floats>(x_of(0), y_of(0), x_of(1), y_of(1), x_of(2), y_of(2), e)) << i;
    }
    return left & rays;
}

/// Which children ray i may hit.
inline unsigned may_hit(const Bvh::Corners& corners, const Shears& shears, int i) {
    const int z = shears.axis[i], x = (z + 1) % 3, y = (z + 2) % 3;
    const float slope_x = shears.slope[0][i], slope_y = shears.slope[1][i];
    const float at_x = shears.at_zero[0][i], at_y = shears.at_zero[1][i];
    unsigned left = 0;
    for (int c = 0; c < Bvh::width; c += half_wide) {
        const auto of = [&](int v, int a) { return load<FewFloats>(corners.at[v][a] + c); };
        const auto x_of = [&](int v) { return of(v, x) - at_x - slope_x * of(v, z); };
        const auto y_of = [&](int v) { return of(v, y) - at_y - slope_y * of(v, z); };
        const FewFloats e = FewFloats{} + shears.error[i];
        left |= may_hit<FewFloats>(x_of(0), y_of(0), x_of(1), y_of(1), x_of(2), y_of(2), e) << c;
    }
    return left;
}

}  // namespace rt
