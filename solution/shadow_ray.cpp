#include "rt/fragments.h"

namespace rt {

/// The ray that asks whether a light is hidden: from a surface towards the light, and no further than the light.
///
/// hit       the point of the surface, its normal and its rounding error: spawn_ray (ray.h) makes a ray of it
/// to_light  unit direction to the point of the light [world]
/// distance  to that point [m]; inf for a directional light
/// returns   the ray; it must not meet the light itself, nor what is behind it: far end at distance x short_of_light
/// blank     a ray of no length: nothing is ever in shadow
///
/// Source: Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
Ray shadow_ray(const Hit& hit, vec3 to_light, Real distance) {
    // BEGIN SOLUTION
    Ray ray = spawn_ray(hit, to_light);
    ray.far = distance * short_of_light;
    return ray;
    // END SOLUTION: return not_started(Ray{hit.point, to_light, 0, 0});
}

}  // namespace rt
