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
    // BEGIN SOLUTION
    if (light.kind == Emitter::Kind::sphere) {
        const vec3 to_center = light.sphere.center - p;
        const Real squared = dot(to_center, to_center), radius2 = sqr(light.sphere.radius);
        const DirectionSample cone = sphere_cone(light.sphere.radius / std::sqrt(std::max(squared, radius2)), u);
        const vec3 direction = frame_about(unit(to_center)).to_world(cone.direction);
        const Real along = dot(to_center, direction);
        const vec3 beside = to_center - along * direction;
        const bool outside = squared > radius2;
        return {direction, along - safe_sqrt(radius2 - dot(beside, beside)), outside ? cone.density : 0};
    }

    // A point of the flat light, uniform in area.
    vec3 point = center(light);
    if (light.kind == Emitter::Kind::quad) {
        point = point + (2 * u.x - 1) * light.quad.u + (2 * u.y - 1) * light.quad.v;
    } else {
        const Frame frame = frame_about(light.disc.normal);
        const vec2 on_disk = light.disc.radius * uniform_disk(u).point;
        point = point + on_disk.x * frame.x + on_disk.y * frame.y;
    }

    // Its density per solid angle.
    const vec3 to_point = point - p, n = normal(light);
    const Real squared = dot(to_point, to_point), distance = std::sqrt(squared);
    const Real inverse = squared > 0 ? 1 / distance : 0;  // p may be the point itself
    const Real cosine = -dot(to_point, n) * inverse * (1 / std::sqrt(dot(n, n)));
    return {to_point * inverse, distance, cosine > 0 ? squared / (cosine * area(light)) : 0};
    // END SOLUTION: return not_started(LightSample{vec3(0, 0, 1), 0, 0});
}

}  // namespace rt
