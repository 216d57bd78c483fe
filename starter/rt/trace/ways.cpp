#include "rt/stages/scatter.h"
#include "rt/trace/words.h"

namespace rt {
namespace {

constexpr const char* fragment_of[] = {"mirror_direction", "glossy_reflection", "refracted_direction",
                                       "translucency",     "color_bleeding",    "scatter_direction"};

/// A way on from a lane, and how much of the light it would carry.
struct Choice {
    WayOn way;
    Real share;
};

/// The ways on from a surface, and the fragments that say so.
std::vector<Choice> ways_from(const Wave& wave, int i, Told& told) {
    const World& world = wave.world;
    const Batch& b = wave.batch;
    const RenderPlan& plan = world.plan;
    const Material& m = world.scene.materials[std::size_t(wave.surfaces.material[i])];
    std::vector<Choice> ways;
    Outgoing out{Color(1), Color(0), Color(0)};
    if ((plan.specular || plan.lobe) && b.depth[i] < world.scene.depth) {
        out = outgoing(m, b, wave.surfaces, i);
        if (m.transmittance != Color(0)) {
            const Real cosine = -dot(b.direction.at(i), wave.surfaces.normal(i));
            const bool behind = wave.surfaces.behind[i] != 0;
            const Real from = behind ? m.ior : 1, to = behind ? 1 : m.ior;
            tell(told, "fresnel_dielectric", "cosine {}, ior {} to {}: {}", text(cosine), text(from), text(to),
                 text(fresnel_dielectric(cosine, from, to)));
        }
        tell(told, "whitted", "local {}, mirror {}, glass {}", text(out.local), text(out.mirror), text(out.glass));
        const bool sharp = m.exponent == inf;
        if (const Real share = largest(out.mirror); share > 0)
            ways.push_back({sharp ? WayOn::mirror : WayOn::glossy, share});
        if (const Real share = largest(out.glass); share > 0)
            ways.push_back({sharp ? WayOn::glass : WayOn::translucent, share});
    }
    if (const Real share = b.bounce[i] < world.scene.bounces ? largest(out.local * m.albedo) : 0; share > 0)
        ways.push_back({WayOn::bounce, share});
    return ways;
}

/// Of several ways, unless all are followed, one is chosen, in proportion to what it carries.
void choose(const Wave& wave, int i, std::vector<Choice>& ways, Told& told) {
    if (ways.size() < 2 || wave.world.plan.split) return;
    Numbers u;
    draw_1d(wave.pattern, wave_dimension(wave.world, wave.number, choice_dimension, wave.pattern.n), wave.batch.key,
            wave.batch.sample, wave.batch.count, u);
    Real sum = 0, upto = 0;
    for (const Choice& c : ways) sum += c.share;
    const auto chosen =
        std::find_if(ways.begin(), ways.end() - 1, [&](const Choice& c) { return sum * u.x[i] < (upto += c.share); });
    tell(told, "way on", "u {}: {}, with probability {}", text(u.x[i]), fragment_of[int(chosen->way)],
         text(chosen->share / sum));
    ways = {*chosen};
}

/// What the fragment of a way answers.
void tell_way(const Wave& wave, int i, WayOn way, Told& told) {
    const Batch& b = wave.batch;
    const Surfaces& s = wave.surfaces;
    const Material& m = wave.world.scene.materials[std::size_t(s.material[i])];
    const vec3 d = b.direction.at(i), n = s.normal(i);
    const Real from = s.behind[i] ? m.ior : 1, to = s.behind[i] ? 1 : m.ior;
    const char* name = fragment_of[int(way)];
    const auto tell_turned = [&](vec3 way_on) {
        const vec3 g = s.hit(i).normal;
        if (way == WayOn::bounce || n == g || !is_astray(way_on, g, leads_inside(way))) return;
        tell(told, "", "on the wrong side of the flat triangle: turned to {}", text(turned(way_on, g)));
    };
    if (way == WayOn::mirror) {
        tell(told, name, "{}", text(mirror_direction(d, n)));
        return tell_turned(mirror_direction(d, n));
    }
    if (way == WayOn::glass) {
        const vec3 refracted = refracted_direction(d, n, from, to);
        tell(told, name, "ior {} to {}: {}", text(from), text(to), text(refracted));
        return tell_turned(refracted);
    }
    Numbers u;
    draw_2d(wave.pattern, wave_dimension(wave.world, wave.number, lobe_dimension, wave.pattern.n), b.key, b.sample,
            b.count, u);
    const Scattered scattered = way == WayOn::glossy        ? glossy_reflection(d, n, m.exponent, u.at(i))
                                : way == WayOn::translucent ? translucency(d, n, from, to, m.exponent, u.at(i))
                                                            : color_bleeding(n, m.albedo, u.at(i));
    tell(told, name, "u {}: direction {}, weight {}", text(u.at(i)), text(scattered.direction), text(scattered.weight));
    tell_turned(scattered.direction);
}

/// A lane that a medium has scattered.
void tell_scattering(const Wave& wave, int i, Told& told) {
    const Batch& b = wave.batch;
    const Index medium = wave.world.plan.medium ? wave.world.regions.medium(b.inside[i]) : nothing;
    if (medium == nothing) return;
    Numbers u;
    draw_2d(wave.pattern, wave_dimension(wave.world, wave.number, phase_dimension, wave.pattern.n), b.key, b.sample,
            b.count, u);
    const DirectionSample sample =
        scatter_direction(b.direction.at(i), wave.world.scene.materials[std::size_t(medium)].medium.g, u.at(i));
    tell(told, fragment_of[int(WayOn::medium)], "u {}: {}, density {} / sr", text(u.at(i)), text(sample.direction),
         text(sample.density));
}

}  // namespace

void trace_ways(const Wave& wave, Trace& trace) {
    const RenderPlan& plan = wave.world.plan;
    for (int i = 0; i < wave.batch.count; ++i) {
        Told& told = trace.of(wave.batch, i);
        if (wave.batch.shape[i] == ended) tell_scattering(wave, i, told);
        if (wave.batch.shape[i] < 0 || (!plan.specular && !plan.lobe && !plan.bounce)) continue;
        std::vector<Choice> ways = ways_from(wave, i, told);
        choose(wave, i, ways, told);
        for (const Choice& c : ways) tell_way(wave, i, c.way, told);
    }
}

}  // namespace rt
