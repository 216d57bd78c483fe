#include "rt/fragments.h"

namespace rt {

/// Where a ray meets a quad, from either side.
///
///     (o + t d - center) . n = 0,    n = u x v,    then |p . u| <= u . u and |p . v| <= v . v for p = o + t d - center
///
/// quad     centre, and two half edges u, v at right angles [world]
/// ray      origin o [world], direction d of any length, and the interval that counts
/// returns  t in units of |d|, near < t < far; else inf, also for a ray in the plane of the quad
/// blank    inf
///
/// Source: Ericson, "Real-Time Collision Detection", section 5.3.
Real hit_quad(const Quad& quad, const Ray& ray) {
    vec3 n = cross(quad.u, quad.v);
    double denominator = dot(ray.direction, n);
    if (denominator == 0) return inf;
    double t = dot(quad.center - ray.origin, n) / denominator;
    if (!(t > ray.near && t < ray.far)) return inf;
    vec3 in_plane = ray.origin + t * ray.direction - quad.center;
    double x = dot(in_plane, quad.u) / dot(quad.u, quad.u);
    double y = dot(in_plane, quad.v) / dot(quad.v, quad.v);
    return std::abs(x) <= 1 && std::abs(y) <= 1 ? t : inf;
}

}  // namespace rt
