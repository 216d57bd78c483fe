#include "rt/fragments.h"

namespace rt {

/// Direction of a ray after it enters another medium, by Snell's law.
///
///     t = e d + (e c - sqrt(1 - e^2 (1 - c^2))) n,    e = ior_from / ior_to,    c = -d . n
///
/// d         unit direction of travel, towards the surface [world]
/// n         unit surface normal on the side that the ray comes from: d . n < 0 [world]
/// ior_from  index of refraction on that side
/// ior_to    index of refraction on the other side
/// returns   unit direction [world]; the zero vector at total internal reflection
/// blank     d
///
/// At grazing incidence 1 - c^2 forgets c, and with almost equal indices 1 - e^2 forgets their difference. With a =
/// ior_from c and b = sqrt((ior_to - ior_from)(ior_to + ior_from) + a^2), t = (ior_from d + (a - b) n)/ior_to forgets
/// neither.
///
/// Source: Heckbert, "Writing a Ray Tracer", An Introduction to Ray Tracing, chapter 7; Higham,
/// "Accuracy and Stability of Numerical Algorithms", 2nd ed., section 1.7.
vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to) {
    // BEGIN SOLUTION
    const Real along = -ior_from * dot(d, n);
    const Real squared = (ior_to - ior_from) * (ior_to + ior_from) + along * along;
    if (squared < 0) return vec3(0);
    return (ior_from * d + (along - std::sqrt(squared)) * n) / ior_to;
    // END SOLUTION: return not_started(d);
}

}  // namespace rt
