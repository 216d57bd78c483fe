#pragma once

#include <array>
#include <cstdint>

#include "rt/math.h"

namespace rt {

/// The points origin + t direction with near < t < far.
struct Ray {
    vec3 origin;               // [world]
    vec3 direction;            // unit, unless said otherwise [world]
    Real near = 0, far = inf;  // in units of |direction|
};

/// Where a ray met a surface.
struct Hit {
    vec3 point;      // [world]
    vec3 normal;     // unit, on the side that the ray came from [world]
    Real error = 0;  // bound of the rounding error of the point, along the normal [world]
};

/// Rays by what sent them.
enum class RayKind { camera, shadow, mirror, glass, lobe, bounce, medium };
constexpr std::array<const char*, 7> ray_kind_names = {"camera", "shadow", "mirror", "glass",
                                                       "lobe",   "bounce", "medium"};
using RayCounts = std::array<std::uint64_t, 7>;

/// A ray towards a light ends at this share of its distance, so that it never meets the light itself.
constexpr Real short_of_light = 1 - 0x1p-30;

/// A ray that leaves a surface in the given direction, on the side to which the direction points, and cannot hit that
/// surface again where it started: the origin moves along the normal by the rounding error of the hit, which grows and
/// shrinks with the scene, and by no absolute epsilon.
///
/// direction  any length [world]
///
/// Source: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., section 6.8.
inline Ray spawn_ray(const Hit& hit, vec3 direction) {
    const Real side = dot(direction, hit.normal) < 0 ? -1.0 : 1.0;
    return {hit.point + (side * hit.error) * hit.normal, direction, 0, inf};
}

}  // namespace rt
