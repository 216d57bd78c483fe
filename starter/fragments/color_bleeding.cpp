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
    // YOUR CODE HERE
    return not_started(Scattered{n, Color(0)});
}

}  // namespace rt
