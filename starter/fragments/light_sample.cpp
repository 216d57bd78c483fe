#include "rt/fragments.h"

namespace rt {

/// A random point of a light with extent, as seen from a point: soft shadows.
///
///     density per solid angle = density per area x distance^2 / cos(angle at the light)
///
/// light    light.kind tells the shape: a quad or a disc shines from its front side, a sphere from its outside;
///          center(light), normal(light) and area(light) are in parts.h
/// p        point of a surface [world]
/// u        random point of the unit square, 0 <= u < 1
/// returns  unit direction from p to the point of the light [world], its distance [m] and the density of the direction
///          [1/sr]; density 0 where the light does not shine on p
/// blank    density 0: the light gives no light
///
/// Of a sphere only the near half is seen from p, in a cone of directions with sine radius / distance (see
/// sphere_cone): uniform directions of that cone leave less noise than points of the whole surface.
///
/// Source: Shirley and Wang, "Monte Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1), 1996.
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    // YOUR CODE HERE
    return not_started(LightSample{vec3(0, 0, 1), 0, 0});
}

}  // namespace rt
