#include "rt/fragments.h"

namespace rt {

/// A random point of a light with extent, as seen from a point: soft shadows.
///
///     density per solid angle = density per area x distance^2 / cos(angle at the light)
///
/// light    light.kind tells the shape: a quad or a disc shines from its front side, a sphere from its outside
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
    vec3 q, n;
    double area;
    if (light.kind == Emitter::Kind::quad) {
        n = unit(cross(light.quad.u, light.quad.v));
        q = light.quad.center + (u.x - 0.5) * light.quad.u + (u.y - 0.5) * light.quad.v;
        area = length(cross(light.quad.u, light.quad.v));
    } else if (light.kind == Emitter::Kind::disc) {
        n = light.disc.normal;
        vec2 xy = light.disc.radius * uniform_disk(u).point;
        q = light.disc.center + frame_about(n).to_world(vec3(xy, 0));
        area = pi * light.disc.radius * light.disc.radius;
    } else {
        // a point anywhere on the sphere; the far half does not shine here
        double z = 1 - 2 * u.x;
        double r = safe_sqrt(1 - z * z);
        n = vec3(r * cos(2 * pi * u.y), r * sin(2 * pi * u.y), z);
        q = light.sphere.center + light.sphere.radius * n;
        area = 4 * pi * light.sphere.radius * light.sphere.radius;
    }
    vec3 to_light = q - p;
    double distance = length(to_light);
    vec3 d = distance > 0 ? to_light / distance : n;
    double cosine = dot(n, -d);
    if (cosine <= 0) return {d, distance, 0};
    return {d, distance, distance * distance / (cosine * area)};
}

}  // namespace rt
