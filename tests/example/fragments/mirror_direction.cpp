#include "rt/fragments.h"

namespace rt {

/// Direction of a ray after a perfect mirror.
///
///     r = d - 2 (d . n) n
///
/// d        direction of travel, towards the surface; any length [world]
/// n        unit surface normal, on either side [world]
/// returns  r, leaving the surface, as long as d [world]
/// blank    d
///
/// Source: Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
vec3 mirror_direction(vec3 d, vec3 n) {
    vec3 along_normal = dot(d, n) * n;
    return d - along_normal - along_normal;
}

}  // namespace rt
