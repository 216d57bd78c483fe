#pragma once

#include "rt/fragments.h"
#include "rt/stages/stages.h"

/// How one path goes on from the surface that it meets. Its next ray carries
///
///     weight of the path x weight of the way / probability of the way x weight of the direction
///
///     weight of the way         outgoing: fresnel_dielectric and whitted
///     probability of the way    Shares: of several ways one is chosen, in proportion to what each would carry
///     direction and its weight  direction_of: the fragment of the way
///
/// scatter.cpp has the loops over the rays of a batch.
namespace rt {

/// The indices of refraction in the order in which a ray meets them.
struct Iors {
    Real from, to;
};
inline Iors iors_of(const Material& m, bool behind) { return {behind ? m.ior : 1, behind ? 1 : m.ior}; }

/// What leaves the surface of lane i towards the viewer, and with which weights.
[[gnu::always_inline]] inline Outgoing outgoing(const Material& m, const Batch& b, const Surfaces& s, int i) {
    Real fresnel = 0;
    if (m.transmittance != Color(0)) {
        const Iors ior = iors_of(m, s.behind[i] != 0);
        fresnel = fresnel_dielectric(-dot(b.direction.at(i), s.normal(i)), ior.from, ior.to);
    }
    return whitted(m, fresnel);
}

/// What each way on from a surface would carry: mirror and glass to the depth of the scene, bounces to their number.
struct Shares {
    Outgoing weights{Color(1), Color(0), Color(0)};
    Real mirror = 0, glass = 0, bounce = 0;
    bool sharp = true;  // mirror and glass have no lobe

    Real sum() const { return mirror + glass + bounce; }
    bool is_one() const { return mirror == sum() || glass == sum() || bounce == sum(); }

    struct Way {
        WayOn way;
        Color weight;
        Real share;  // of the sum
    };
    Way by_mirror() const { return {sharp ? WayOn::mirror : WayOn::glossy, weights.mirror, mirror}; }
    Way by_glass() const { return {sharp ? WayOn::glass : WayOn::translucent, weights.glass, glass}; }
    Way by_bounce() const { return {WayOn::bounce, weights.local, bounce}; }
    Way chosen(Real u) const {
        const Real x = u * sum();
        return x < mirror ? by_mirror() : x < mirror + glass ? by_glass() : by_bounce();
    }
};

/// Whether mirrors, glass and lobes lead on from lane i.
inline bool leads_on(const Wave& wave, int i) {
    return (wave.world.plan.specular || wave.world.plan.lobe) && wave.batch.depth[i] < wave.world.scene.depth;
}

[[gnu::always_inline]] inline Shares shares_of(const Wave& wave, int i) {
    const Material& m = wave.material(i);
    Shares shares;
    shares.sharp = m.exponent == inf;
    if (leads_on(wave, i)) {
        shares.weights = outgoing(m, wave.batch, wave.surfaces, i);
        shares.mirror = largest(shares.weights.mirror), shares.glass = largest(shares.weights.glass);
    }
    // What color_bleeding carries has the albedo in it.
    if (wave.batch.bounce[i] < wave.world.scene.bounces) shares.bounce = largest(shares.weights.local * m.albedo);
    return shares;
}

/// What decides where a ray goes on from a surface.
struct Arrival {
    vec3 direction, normal;  // of travel; shading
    Real exponent;
    Iors ior;
    Color albedo;
};

/// Where a way leads, and with which share of its light.
[[gnu::always_inline]] inline Scattered direction_of(WayOn way, const Arrival& a, vec2 u) {
    const vec3 d = a.direction, n = a.normal;
    if (way == WayOn::mirror) return {mirror_direction(d, n), Color(1)};
    if (way == WayOn::glossy) return glossy_reflection(d, n, a.exponent, u);
    if (way == WayOn::glass) return {refracted_direction(d, n, a.ior.from, a.ior.to), Color(1)};
    if (way == WayOn::translucent) return translucency(d, n, a.ior.from, a.ior.to, a.exponent, u);
    return color_bleeding(n, a.albedo, u);
}

}  // namespace rt
