#include "rt/stages/direct.h"

#include "rt/stages/reflectances.h"
#include "rt/stages/weighed.h"

/// The light that surfaces reflect straight from the lamps. Fragments are called in direct.h, for one ray; here are the
/// loops over all of a batch:
///
///     shine_on_surfaces, ..._light  the light of one lamp, and the shadow rays it depends on
///     shine_on_lobes                the same for glossy lobes; nobody needs it for the assignment
///     send_shadow_rays              sends them, and adds what arrives
///     direct_stage                  lamp after lamp
///
/// What the materials of all lanes reflect is looked up before, in reflectances.cpp; for_each_lamp is in lamps.h.
namespace rt {
namespace {

/// highlights  whether there are any: without, direct_light is compiled for black ones
template <bool highlights, class L>
[[gnu::noinline]] void shine_on_surfaces(const L& lamps_in_memory, const Numbers& u, const Batch& b, const Surfaces& s,
                                         const Reflectances& reflectances, Batch& shadow, Colors& light) {
    const L lamps = lamps_in_memory;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        Material m;
        m.albedo = reflectances.albedo.at(i);
        if constexpr (highlights) m.specular = reflectances.specular.at(i), m.shininess = reflectances.shininess[i];
        const Lit lit = from_lamp(lamps.at(i), m, s.hit(i), s.normal(i), -b.direction.at(i), u.at(i));
        light.set(i, lit.light);
        shadow.set_ray(i, lit.shadow);
    }
}

void point_light(const Wave& wave, const PointLight& lamp, Batch& shadow, Colors& light) {
    const Batch& b = wave.batch;
    const Surfaces& s = wave.surfaces;
    for (int i = 0; i < b.count; ++i) {
        Lit lit{Color(0), no_ray};
        if (s.material[i] != nothing) {
            const Material& m = wave.material(i);
            if (m.albedo != Color(0) || m.specular != Color(0))
                lit = from_point_light(lamp, m, s.hit(i), s.normal(i), -b.direction.at(i));
        }
        light.set(i, lit.light);
        shadow.set_ray(i, lit.shadow);
    }
}

[[gnu::noinline]] void environment_light(Color radiance_in_memory, const Numbers& u, const Surfaces& s,
                                         const Reflectances& reflectances, Batch& shadow, Colors& light) {
    const Color radiance = radiance_in_memory;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Lit lit = from_environment(radiance, reflectances.albedo.at(i), s.hit(i), s.normal(i), u.at(i));
        light.set(i, lit.light);
        shadow.set_ray(i, lit.shadow);
    }
}

bool all_bounce_to_sky(const World& world, const Batch& b) {
    int bounce = 0;
    for (int i = 0; i < b.count; ++i) bounce += bounces_to_sky(world, b, i);
    return bounce == b.count;
}

void ambient_light(const Wave& wave, Colors& found) {
    for (int i = 0; i < wave.batch.count; ++i) {
        if (wave.surfaces.material[i] == nothing || wave.material(i).ambient == Color(0)) continue;
        const Color light = from_ambient_light(wave.world.scene.ambient, wave.material(i), wave.surfaces.normal(i));
        found.set(i, found.at(i) + wave.batch.weight.at(i) * light);
    }
}

template <class L>
[[gnu::noinline]] void shine_on_lobes(const L& lamps_in_memory, const Numbers& u, const Batch& b, const Surfaces& s,
                                      const Lobes& lobes, Batch& shadow, Colors& light) {
    const L lamps = lamps_in_memory;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Lit lit = from_lamp_by_lobe(lamps.at(i), lobes.mirror.at(i), lobes.exponent[i], s.hit(i), s.normal(i),
                                          -b.direction.at(i), u.at(i));
        light.set(i, lit.light);
        shadow.set_ray(i, lit.shadow);
    }
}

/// Dims what shadow rays carry by the medium in which their surfaces lie.
void dim(const World& world, const Batch& b, const Batch& shadow, Colors& light) {
    for (int i = 0; i < b.count; ++i)
        if (shadow.far[i] > 0) light.set(i, left_around(world, b.inside[i], shadow.far[i]) * light.at(i));
}

/// Sends the shadow rays that carry any light, adds the light of those that meet nothing, and counts them.
///
/// through  whether boundaries that bend no light let the rays pass
[[gnu::noinline]] void send_shadow_rays(const World& world, const Batch& b, bool through, Colors& light, Batch& shadow,
                                        Colors& found, Chunk& chunk) {
    Index sent = 0;
    for (Index i = 0; i < lanes; ++i) {
        const bool wanted = bool(light.x[i] != 0) | bool(light.y[i] != 0) | bool(light.z[i] != 0);
        sent += wanted & (i < b.count);
        shadow.far[i] = wanted ? shadow.far[i] : no_ray.far;
    }
    if (sent == 0) return;
    shadow.count = b.count;
    if (through) {
        through_stage(world, b.inside, shadow, light);
    } else {
        any_hit_stage(world, shadow);
        if (world.plan.medium) dim(world, b, shadow, light);
    }
    for (int i = 0; i < lanes; ++i) {
        const bool arrives = shadow.shape[i] == nothing;
        found.x[i] += arrives ? b.weight.x[i] * light.x[i] : 0;
        found.y[i] += arrives ? b.weight.y[i] * light.y[i] : 0;
        found.z[i] += arrives ? b.weight.z[i] * light.z[i] : 0;
    }
    chunk.rays[int(RayKind::shadow)] += std::uint64_t(sent);
}

}  // namespace

void direct_stage(const Wave& wave, Batch& shadow, Colors& found, Chunk& chunk) {
    const World& world = wave.world;
    const RenderPlan& plan = world.plan;
    const Batch& b = wave.batch;
    const Surfaces& s = wave.surfaces;
    if (world.scene.ambient != Color(0)) ambient_light(wave, found);
    Reflectances reflectances;
    Lobes lobes;
    const bool reflects = look_up_reflectances(world, b.count, s, reflectances);
    const bool weighs = look_up_lobes(world, b, s, lobes);
    if (!reflects && !weighs) return;
    Colors light;  // of one lamp, as it leaves the surfaces
    const auto send = [&](bool through) { send_shadow_rays(world, b, through, light, shadow, found, chunk); };
    for (int i = 0; i < lanes; ++i) shadow.time[i] = b.time[i];
    if (reflects)
        for (const PointLight& lamp : world.scene.lights) {
            point_light(wave, lamp, shadow, light);
            send(plan.through);
        }
    for_each_lamp(wave, s, lanes, [&](const auto& lamps, const Numbers& u) {
        if (weighs) {
            shine_on_lobes(lamps, u, b, s, lobes, shadow, light);
            // The lobe's rays find lamps behind such boundaries, and those count in full: their density is not known
            // there.
            send(false);
        }
        if (!reflects) return;
        plan.phong ? shine_on_surfaces<true>(lamps, u, b, s, reflectances, shadow, light)
                   : shine_on_surfaces<false>(lamps, u, b, s, reflectances, shadow, light);
        send(plan.through);
    });
    if (reflects && plan.environment_lit && !all_bounce_to_sky(world, b)) {
        Numbers u;
        wave.draw_2d(environment_dimension, lanes, u);
        environment_light(world.scene.environment, u, s, reflectances, shadow, light);
        for (int i = 0; i < b.count; ++i)
            if (bounces_to_sky(world, b, i)) light.set(i, Color(0));
        send(plan.through);
    }
}

}  // namespace rt
