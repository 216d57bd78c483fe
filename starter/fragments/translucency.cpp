#include "rt/fragments.h"

namespace rt {

/// A ray of the glossy lobe about the refracted direction.
///
///     BTDF = (n + 2)/(2 pi) cos(alpha)^n,    weight = BTDF x |cos(theta)| / density
///
/// alpha the angle to the refracted direction, theta the angle to the normal; weight 0 for a ray that would not cross
/// the surface, and at total internal reflection.
///
/// d         unit direction of travel, towards the surface [world]
/// n         unit surface normal on the side that the ray comes from [world]
/// ior_from  index of refraction on that side
/// ior_to    index of refraction on the other side
/// exponent  of the lobe
/// u         random point of the unit square, 0 <= u < 1
/// returns   unit direction [world] and weight, without the material's transmittance
/// blank     the refracted direction, weight 1
///
/// Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    // YOUR CODE HERE
    return not_started(Scattered{refracted_direction(d, n, ior_from, ior_to), Color(1)});
}

}  // namespace rt
