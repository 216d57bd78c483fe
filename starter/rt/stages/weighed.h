#pragma once

#include "rt/lamps/importance.h"
#include "rt/media/phase.h"
#include "rt/stages/direct.h"

/// Light of one lamp that a glossy lobe or a medium sends on, by a point of the lamp; weighed against the rays that
/// they send on themselves, which may find the lamp too. Nobody needs this file for the assignment.
namespace rt {

/// To the viewer, from a glossy lobe.
///
/// mirror  what the lobe reflects [1]
[[gnu::always_inline]] inline Lit from_lamp_by_lobe(const ChosenLamp& chosen, Color mirror, Real exponent,
                                                    const Hit& hit, vec3 n, vec3 to_viewer, vec2 u) {
    LightSample sample = light_sample(chosen.lamp, hit.point, u);
    adapt(sample, chosen, hit.point, u);
    const Real cosine = dot(n, sample.direction), of_lobe = lobe_density(exponent, sample.direction, n, to_viewer);
    // BRDF x cosine, from the density of the lobe, over the density of the lamp's point.
    const Real reflected = (exponent + 2) / (exponent + 1) * of_lobe * cosine / sample.density;
    const Real share = reflected * power_heuristic(sample.density, of_lobe);
    const Real seen = (bool(sample.density > 0) & bool(cosine > 0)) ? share : 0;
    return {seen * mirror * chosen.lamp.radiance, shadow_ray(hit, sample.direction, sample.distance)};
}

/// Light that a medium scatters, not yet weighed: how far a path might have come is known when the shadow ray has
/// arrived.
struct LitMedium {
    Lit lit{Color(0), no_ray};
    Real of_lamp = 0, of_phase = 0;  // with which densities the lamp's point and the scattering take this way [1/sr]

    Real weight(const Passed& passed, Index depth, int most) const {
        return power_heuristic(of_lamp, of_phase * passed.by_path(int(depth), most));
    }
};

/// d  of travel before the scattering
inline LitMedium from_lamp_by_medium(const ChosenLamp& chosen, const Medium& medium, vec3 point, vec3 d, vec2 u) {
    LightSample sample = light_sample(chosen.lamp, point, u);
    adapt(sample, chosen, point, u);
    if (!(sample.density > 0)) return {};
    const Real of_phase = phase(d, sample.direction, medium.g);
    return {{of_phase / sample.density * medium.albedo * chosen.lamp.radiance,
             shadow_ray({point, sample.direction}, sample.direction, sample.distance)},
            sample.density,
            of_phase};
}

}  // namespace rt
