#include "rt/fragments.h"

namespace rt {

/// The irradiance at a surface from a light without extent, unless something is in between.
///
///     E = I max(0, n . d) / r^2        a point light: d the unit direction to it, r its distance
///     E = H max(0, n . d)              a directional one: the limit for a light far away
///
/// light    position [world] and intensity I [W/sr]; or, where light.directional is set, position is the unit vector d
///          towards the light and intensity its irradiance H on a surface that faces it [W/m2]
/// p        point of the surface [world]
/// n        unit surface normal [world]
/// returns  irradiance [W/m2]
/// blank    pi: each surface shows its own colour, unlit
///
/// Source: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., section 4.1.
Color point_irradiance(const PointLight& light, vec3 p, vec3 n) {
    // BEGIN SOLUTION
    const vec3 to_light = light.directional ? light.position : light.position - p;
    const Real squared = dot(to_light, to_light);
    const Real cosine = dot(n, to_light) / std::sqrt(squared);
    return light.intensity * ((cosine > 0 ? cosine : 0) / (light.directional ? 1 : squared));
    // END SOLUTION: return not_started(Color(pi));
}

}  // namespace rt
