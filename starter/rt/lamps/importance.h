#pragma once

#include "rt/lamps/solid_angle.h"
#include "rt/world.h"

/// Multiple importance sampling of lamps that glossy lobes reflect: points of the lamp and rays of the lobe both find
/// them, and each is weighed by its density against the other's. Nobody needs this file for the assignment.
///
/// Source: Veach and Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995.
namespace rt {

/// The weight of a sample of density p that the other technique would have taken with density q: the power heuristic.
[[gnu::always_inline]] inline Real power_heuristic(Real p, Real q) { return p > 0 ? 1 / (1 + sqr(q / p)) : 0; }

/// The density with which phong_lobe takes a direction about the mirror direction [1/sr].
///
/// direction  unit, from the surface [world]
/// n          unit normal, on the side of the viewer [world]
/// to_viewer  unit [world]
[[gnu::always_inline]] inline Real lobe_density(Real exponent, vec3 direction, vec3 n, vec3 to_viewer) {
    const vec3 apart = 2 * dot(n, direction) * n - direction - to_viewer;
    const Real off = dot(apart, apart) / 2;  // 1 - cos(alpha), with all its digits
    const Real to_the_n = exp(exponent * log1p(-(off < 1 ? off : 0)));
    return off < 1 ? (exponent + 1) / (2 * pi) * to_the_n : 0;
}

/// The density with which the point of an emitter that a ray hits would have been taken [1/sr].
///
/// lamp      what the surface stage knows of the emitter
/// ray       unit direction, from the surface [world]
/// distance  along the ray to the emitter [m]
inline Real light_density(const World& world, const SurfaceRecord& lamp, const Ray& ray, Real distance) {
    const Emitter& emitter = world.emitters[std::size_t(lamp.emitter)];
    const Real chosen = world.plan.one_lamp ? world.lamp_tree.probability(std::size_t(lamp.emitter), ray.origin) : 1;
    if (emitter.kind == Emitter::Kind::sphere) {
        const vec3 to_center = lamp.center - ray.origin;
        const Real sine2 = sqr(lamp.radius) / dot(to_center, to_center);
        return chosen * (1 + safe_sqrt(1 - sine2)) / (2 * pi * sine2);  // 1 - cos = sine^2 / (1 + cos)
    }
    if (world.plan.solid_angle && emitter.kind == Emitter::Kind::quad)
        if (const SeenQuad seen = seen_from(emitter.quad, ray.origin); seen.is_wide()) return chosen / seen.solid_angle;
    return chosen * sqr(distance) / (std::abs(dot(ray.direction, lamp.normal)) * lamp.area);
}

}  // namespace rt
