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
/// both of its triangles the same number with opposite signs.
///
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    // Moeller, Trumbore: "Fast, Minimum Storage Ray/Triangle Intersection"
    vec3 e1 = triangle.b - triangle.a;
    vec3 e2 = triangle.c - triangle.a;
    vec3 pvec = cross(ray.direction, e2);
    double det = dot(e1, pvec);
    if (std::abs(det) < 1e-12) return inf;
    vec3 tvec = ray.origin - triangle.a;
    double u = dot(tvec, pvec) / det;
    vec3 qvec = cross(tvec, e1);
    double v = dot(ray.direction, qvec) / det;
    double t = dot(e2, qvec) / det;
    if (u < 0 || v < 0 || u + v > 1) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}

}  // namespace rt
