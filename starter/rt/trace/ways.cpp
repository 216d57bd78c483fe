#include "rt/stages/scatter.h"
#include "rt/trace/words.h"

namespace rt {
namespace {

constexpr const char* fragment_of[] = {"mirror_direction", "glossy_reflection", "refracted_direction",
                                       "translucency",     "color_bleeding",    "scatter_direction"};

/// The ways on from a surface, and the fragments that say so.
Shares tell_shares(const Wave& wave, int i, Told& told) {
    const Material& m = wave.material(i);
    const Shares shares = shares_of(wave, i);
    if (!leads_on(wave, i)) return shares;
    if (m.transmittance != Color(0)) {
        const Real cosine = -dot(wave.batch.direction.at(i), wave.surfaces.normal(i));
        const Iors ior = iors_of(m, wave.surfaces.behind[i] != 0);
        tell(told, "fresnel_dielectric", "cosine {}, ior {} to {}: {}", text(cosine), text(ior.from), text(ior.to),
             text(fresnel_dielectric(cosine, ior.from, ior.to)));
    }
    const auto& [local, mirror, glass] = shares.weights;
    tell(told, "whitted", "local {}, mirror {}, glass {}", text(local), text(mirror), text(glass));
    return shares;
}

/// The way that is chosen among several.
WayOn tell_choice(const Wave& wave, int i, const Shares& shares, Told& told) {
    if (shares.is_one()) return shares.chosen(0).way;
    const Real u = number_of(wave, i, choice_dimension);
    const Shares::Way chosen = shares.chosen(u);
    tell(told, "way on", "u {}: {}, with probability {}", text(u), fragment_of[int(chosen.way)],
         text(chosen.share / shares.sum()));
    return chosen.way;
}

/// What the fragment of a way answers.
void tell_way(const Wave& wave, int i, WayOn way, Told& told) {
    const Surfaces& s = wave.surfaces;
    const Material& m = wave.material(i);
    const Iors ior = iors_of(m, s.behind[i] != 0);
    const vec2 u = is_sharp(way) ? vec2(0) : numbers_of(wave, i, lobe_dimension);
    const Scattered on = direction_of(way, {wave.batch.direction.at(i), s.normal(i), m.exponent, ior, m.albedo}, u);
    const char* name = fragment_of[int(way)];
    if (way == WayOn::mirror)
        tell(told, name, "{}", text(on.direction));
    else if (way == WayOn::glass)
        tell(told, name, "ior {} to {}: {}", text(ior.from), text(ior.to), text(on.direction));
    else
        tell(told, name, "u {}: direction {}, weight {}", text(u), text(on.direction), text(on.weight));
    const vec3 g = s.hit(i).normal;
    if (way != WayOn::bounce && s.normal(i) != g && is_astray(on.direction, g, leads_inside(way)))
        tell(told, "", "on the wrong side of the flat triangle: turned to {}", text(turned(on.direction, g)));
}

/// A lane that a medium has scattered.
void tell_scattering(const Wave& wave, int i, Told& told) {
    const Batch& b = wave.batch;
    const Index medium = wave.world.plan.medium ? wave.world.regions.medium(b.inside[i]) : nothing;
    if (medium == nothing) return;
    const vec2 u = numbers_of(wave, i, phase_dimension);
    const DirectionSample sample =
        scatter_direction(b.direction.at(i), wave.world.scene.materials[std::size_t(medium)].medium.g, u);
    tell(told, fragment_of[int(WayOn::medium)], "u {}: {}, density {} / sr", text(u), text(sample.direction),
         text(sample.density));
}

}  // namespace

void trace_ways(const Wave& wave, Trace& trace) {
    const RenderPlan& plan = wave.world.plan;
    for (int i = 0; i < wave.batch.count; ++i) {
        Told& told = trace.of(wave.batch, i);
        if (wave.batch.shape[i] == ended) tell_scattering(wave, i, told);
        if (wave.batch.shape[i] < 0 || (!plan.specular && !plan.lobe && !plan.bounce)) continue;
        const Shares shares = tell_shares(wave, i, told);
        if (plan.split) {
            if (shares.mirror > 0) tell_way(wave, i, shares.by_mirror().way, told);
            if (shares.glass > 0) tell_way(wave, i, shares.by_glass().way, told);
        } else if (shares.sum() != 0) {
            tell_way(wave, i, tell_choice(wave, i, shares, told), told);
        }
    }
}

}  // namespace rt
