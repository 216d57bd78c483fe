#include "rt/fragments.h"

namespace rt {

/// A direction of a cone about z, uniformly distributed: the directions towards a sphere.
///
///     1 - cos(theta) = u.x m,    m = 1 - cos(theta_max),    phi = 2 pi u.y,    density = 1/(2 pi m)
///
/// Another map of the square with this density is as good.
///
/// sine     sin(theta_max) = radius / distance of the sphere, 0 < sine <= 1
/// u        random point of the unit square, 0 <= u < 1
/// returns  unit direction, theta its angle to the z axis, and its density [1/sr]
/// blank    the z axis
///
/// For a small sphere 1 - cos cancels: m = s^2/(1 + sqrt(1 - s^2)) does not. Nor does the sine, sqrt(k (2 - k)) with
/// k = 1 - cos(theta).
///
/// Source: Shirley and Wang, "Monte Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1), 1996; Higham,
/// "Accuracy and Stability of Numerical Algorithms", 2nd ed., section 1.7.
DirectionSample sphere_cone(Real sine, vec2 u) {
    // BEGIN SOLUTION
    const Real m = sine * sine / (1 + safe_sqrt(1 - sine * sine));
    const Real k = u.x * m;
    const vec2 p = safe_sqrt(k * (2 - k)) * unit_circle(u.y);
    return {{p.x, p.y, 1 - k}, 1 / (2 * pi * m)};
    // END SOLUTION: return not_started(DirectionSample{{0, 0, 1}, 1 / pi});
}

}  // namespace rt
