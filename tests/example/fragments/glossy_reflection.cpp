#include "rt/fragments.h"

namespace rt {

/// A ray of the glossy lobe about the mirror direction: off-axis specularity.
///
///     BRDF = (n + 2)/(2 pi) cos(alpha)^n,    weight = BRDF x cos(theta) / density
///
/// alpha the angle to the mirror direction, theta the angle to the normal; weight 0 for a ray that would go below the
/// surface.
///
/// d         unit direction of travel, towards the surface [world]
/// n         unit surface normal on the side that the ray comes from [world]
/// exponent  of the lobe
/// u         random point of the unit square, 0 <= u < 1
/// returns   unit direction [world] and weight, without the material's reflectance
/// blank     the mirror direction, weight 1
///
/// Source: Lafortune and Willems, "Using the Modified Phong Reflectance Model", TR CW197, 1994.
Scattered glossy_reflection(vec3 d, vec3 n, Real exponent, vec2 u) {
    DirectionSample s = phong_lobe(exponent, u);
    vec3 w = frame_about(mirror_direction(d, n)).to_world(s.direction);
    double brdf_over_density = (exponent + 2) / (exponent + 1);
    return {w, Color(brdf_over_density * std::abs(dot(w, n)))};
}

}  // namespace rt
