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
    // YOUR CODE HERE
    return not_started(inf);
}

}  // namespace rt
