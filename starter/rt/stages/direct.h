#pragma once

#include "rt/stages/lamps.h"

/// The light of one lamp that a surface reflects to the viewer, by one sample of its integral:
///
///     f(d, c) cos(theta) L / (p P)  if the shadow ray arrives, else 0
///
///     light_sample  finds d, the direction to a point of the lamp, and its density p
///     adapt         multiplies the density by P, the probability with which this lamp was chosen; mostly 1
///     direct_light  is the whole fraction, where the density is p P
///     shadow_ray    is the ray on which it depends
///
/// A light without extent has one direction and no density: point_irradiance, phong. All is for one ray; direct.cpp has
/// the loops over those of a batch.
namespace rt {

/// What a surface sends to the viewer if nothing stops the shadow ray.
struct Lit {
    Color light;  // [W/(sr m2)]
    Ray shadow;
};

/// From a point of a lamp with extent.
[[gnu::always_inline]] inline Lit from_lamp(const ChosenLamp& chosen, const Material& m, const Hit& hit, vec3 n,
                                            vec3 to_viewer, vec2 u) {
    LightSample sample = light_sample(chosen.lamp, hit.point, u);
    adapt(sample, chosen, hit.point, u);
    return {direct_light(m, chosen.lamp.radiance, sample, n, to_viewer),
            shadow_ray(hit, sample.direction, sample.distance)};
}

/// Where a light without extent is.
struct Towards {
    vec3 direction;  // unit [world]
    Real distance;   // [m]
};
inline Towards towards(const PointLight& lamp, vec3 p) {
    const vec3 to = lamp.directional ? lamp.position : lamp.position - p;
    const Real distance = std::sqrt(dot(to, to));
    return {to * (1 / distance), lamp.directional ? inf : distance};
}

/// From a light without extent. A surface with a highlight is shaded by phong, any other by Lambert's law.
inline Lit from_point_light(const PointLight& lamp, const Material& m, const Hit& hit, vec3 n, vec3 to_viewer) {
    const Towards to = towards(lamp, hit.point);
    Color light;
    if (m.specular == Color(0))
        light = point_irradiance(lamp, hit.point, n) * m.albedo / pi;
    else
        light = phong(m, Color(0), point_irradiance(lamp, hit.point, to.direction), n, to.direction, to_viewer);
    return {light, shadow_ray(hit, to.direction, to.distance)};
}

/// Whether a diffuse ray from lane i brings the light of the environment.
inline bool bounces_to_sky(const World& world, const Batch& b, int i) {
    return world.plan.sky_by_bounces && b.bounce[i] < world.scene.bounces;
}

/// From a direction of the environment. Not by direct_light: highlights are of lamps alone, and cos(theta) is z, before
/// the direction is turned to the world.
[[gnu::always_inline]] inline Lit from_environment(Color radiance, Color albedo, const Hit& hit, vec3 n, vec2 u) {
    const DirectionSample sample = cosine_hemisphere(u);
    const Color light = sample.direction.z / (pi * sample.density) * albedo * radiance;
    return {light, shadow_ray(hit, frame_about(n).to_world(sample.direction), inf)};
}

/// The ambient light, by phong: without irradiance its directions do not matter.
inline Color from_ambient_light(Color ambient, const Material& m, vec3 n) {
    return phong(m, ambient, Color(0), n, n, n);
}

}  // namespace rt
