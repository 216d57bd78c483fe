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
/// Far from the world's origin o + t d would be rounded to the large numbers there: p comes from the difference o -
/// center, which is small where the quad is near. No test for a ray in the plane: t is then inf or NaN, and every
/// comparison with it says no.
///
/// Source: Ericson, "Real-Time Collision Detection", section 5.3.
Real hit_quad(const Quad& quad, const Ray& ray) {
    // YOUR CODE HERE
    return not_started(inf);
}

}  // namespace rt
