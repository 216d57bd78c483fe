#include "rt/fragments.h"

namespace rt {

/// Where a ray first meets a sphere.
///
///     |o + t d - c|^2 = r^2,    the least root with near < t < far
///
/// sphere   centre c [world] and radius r > 0
/// ray      origin o [world], direction d of any length, and the interval that counts
/// returns  t in units of |d|; inf where no root lies in the interval; the far root when the ray starts inside
/// blank    inf
///
/// The textbook formula b^2 - a c cancels for spheres that are small, far away or huge. Take the discriminant from the
/// point of the ray that is nearest to the centre, l = f - (f.d/d.d) d with f = o - c: it is r^2 - l.l. And take the
/// root whose terms have one sign first, the other one from the product of both.
///
/// Source: Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7.
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    // BEGIN SOLUTION
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction), over_a = 1 / a;
    const Real b = -dot(f, ray.direction);
    const vec3 l = f + (b * over_a) * ray.direction;
    const Real discriminant = sphere.radius * sphere.radius - dot(l, l);
    if (!(discriminant >= 0)) return inf;
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    const Real q = b + std::copysign(std::sqrt(a * discriminant), b);
    const Real t0 = c / q, t1 = q * over_a;
    const Real first = t0 < t1 ? t0 : t1, last = t0 < t1 ? t1 : t0;
    if (first > ray.near && first < ray.far) return first;
    if (last > ray.near && last < ray.far) return last;
    return inf;
    // END SOLUTION: return not_started(inf);
}

}  // namespace rt
