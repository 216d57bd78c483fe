#include "rt/fragments.h"

namespace rt {

/// A direction of the hemisphere about z, with a density proportional to its cosine.
///
///     density = cos(theta) / pi
///
/// Raise a uniform point of the unit disk to the hemisphere.
///
/// Another map of the square with this density is as good.
///
/// u        random point of the unit square, 0 <= u < 1
/// returns  unit direction, z >= 0, and its density [1/sr]
/// blank    the z axis
///
/// Source: Malley's method; Shirley and Wang, "Monte Carlo Techniques for Direct Lighting Calculations",
/// ACM TOG 15(1), 1996.
DirectionSample cosine_hemisphere(vec2 u) {
    // BEGIN SOLUTION
    const vec2 p = std::sqrt(u.x) * unit_circle(u.y);
    const Real z = safe_sqrt(1 - u.x);
    return {{p.x, p.y, z}, z / pi};
    // END SOLUTION: return not_started(DirectionSample{{0, 0, 1}, 1 / pi});
}

}  // namespace rt
