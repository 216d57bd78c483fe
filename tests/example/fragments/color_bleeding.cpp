#include "rt/fragments.h"

namespace rt {

/// The next ray of a path at a diffuse surface: colours bleed from one surface to the next.
///
///     weight = BRDF x cos(theta) / density,    BRDF = albedo / pi
///
/// With the density cos(theta)/pi of cosine_hemisphere the weight does not depend on the direction.
///
/// n        unit normal, on the side that the path comes from [world]
/// albedo   of the surface [1]
/// u        random point of the unit square, 0 <= u < 1
/// returns  unit direction above the surface [world], and weight
/// blank    weight 0: the path ends
///
/// Source: Kajiya, "The Rendering Equation", SIGGRAPH 1986.
Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    // uniform on the hemisphere, density 1/(2 pi)
    double z = u.x;
    double r = safe_sqrt(1 - z * z);
    vec3 w = frame_about(n).to_world(vec3(r * cos(2 * pi * u.y), r * sin(2 * pi * u.y), z));
    return {w, albedo / pi * z / (1 / (2 * pi))};
}

}  // namespace rt
