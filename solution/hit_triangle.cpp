#include <algorithm>

#include "rt/fragments.h"

namespace rt {

/// Where a ray meets a triangle, from either side.
///
///     o + t d = u a + v b + w c,    u + v + w = 1,    u, v, w >= 0
///
/// triangle  corners a, b, c [world]
/// ray       origin o [world], direction d of any length, and the interval that counts
/// returns   t in units of |d|, near < t < far; else inf. A triangle without area is never hit
/// blank     inf
///
/// Two triangles that share an edge must leave no gap between them. Turn and shear space so that the ray starts at 0
/// and runs along z: then u, v and w are the signs of three edge functions p.x q.y - p.y q.x, and a shared edge gives
/// both of its triangles the same number with opposite signs, bit by bit. A product's rounding never swaps which of two
/// is larger, so the sign is right or the number is 0, and 0 counts for both triangles.
///
/// For a needle u, v and w have few digits left, so t comes from the plane, o + t d on (b - a) x (c - a), which is as
/// good for a needle as for any other as long as the cross product does not cancel: then a ray that leaves the triangle
/// meets it behind.
///
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    // BEGIN SOLUTION
    // The axis along which the ray runs most becomes z; the other two follow in cyclic order.
    const vec3 d = ray.direction;
    const Real x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    const bool along_x = x > y && x > z, along_y = !along_x && y > z;
    const auto pick = [=](Real if_x, Real if_y, Real if_z) { return along_x ? if_x : along_y ? if_y : if_z; };
    const auto turned = [=](vec3 p) { return vec3{pick(p.y, p.z, p.x), pick(p.z, p.x, p.y), pick(p.x, p.y, p.z)}; };
    const vec3 to = turned(d);
    const vec3 a = turned(triangle.a - ray.origin), b = turned(triangle.b - ray.origin),
               c = turned(triangle.c - ray.origin);

    // Shear, so that the ray is the z axis.
    const Real shear_x = to.x / to.z, shear_y = to.y / to.z;
    const Real ax = a.x - shear_x * a.z, ay = a.y - shear_y * a.z;
    const Real bx = b.x - shear_x * b.z, by = b.y - shear_y * b.z;
    const Real cx = c.x - shear_x * c.z, cy = c.y - shear_y * c.z;

    // Inside, all three edge functions have one sign.
    const Real u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return inf;
    if (u + v + w == 0) return inf;

    // How far: to the plane, but between the corners. Edge-on there is nothing that the neighbours do not cover.
    const vec3 n = exact_cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const Real slope = dot(d, n);
    if (!(slope * slope > sqr(16 * roundoff) * dot(d, d) * dot(n, n))) return inf;
    const Real ta = a.z / to.z, tb = b.z / to.z, tc = c.z / to.z;
    const Real low = std::min(ta, std::min(tb, tc)), high = std::max(ta, std::max(tb, tc));
    const Real t = std::clamp(dot(triangle.a - ray.origin, n) / slope, low, high);
    return t > ray.near && t < ray.far ? t : inf;
    // END SOLUTION: return not_started(inf);
}

}  // namespace rt
