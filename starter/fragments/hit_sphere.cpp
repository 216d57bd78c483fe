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
    // YOUR CODE HERE
    return not_started(inf);
}

}  // namespace rt
