#include "rt/fragments.h"
#include "rt/lamps/importance.h"
#include "rt/stages/lamps.h"
#include "rt/stages/reflectances.h"

/// The light that surfaces reflect straight from the lamps. Each lamp adds one sample of its integral:
///
///     f(d, c) cos(theta) L / (p P)  if the shadow ray arrives, else 0
///
///     d  direction to a point of the lamp, and p its density; P: the probability with which this lamp was chosen
///
/// In this file, in this order; what the materials of all lanes reflect is looked up before, in reflectances.cpp:
///
///     from_...                 one lane: the light of one lamp, by your fragments, and the shadow ray it depends on
///     shine_on_..., ..._light  the same for all lanes
///     send_shadow_rays         and add what arrives
///     direct_stage             lamp after lamp
namespace rt {
namespace {

/// What a surface sends to the viewer if nothing stops the shadow ray.
struct Lit {
    Color light;  // [W/(sr m2)]
    Ray shadow;
};

/// From a point of a lamp with extent.
///
/// chosen  the probability with which this lamp was
template <bool by_angle>
[[gnu::always_inline]] inline Lit from_lamp(const Emitter& lamp, Real chosen, const Material& m, const Hit& hit, vec3 n,
                                            vec3 to_viewer, vec2 u) {
    LightSample sample = light_sample(lamp, hit.point, u);
    if constexpr (by_angle) sample = by_angle_or(sample, lamp.quad, hit.point, u);
    sample.density *= chosen;
    return {direct_light(m, lamp.radiance, sample, n, to_viewer), shadow_ray(hit, sample.direction, sample.distance)};
}

/// From a point of a lamp with extent into a glossy lobe, weighed against the rays of the lobe, which may find it too.
///
/// mirror  what the lobe reflects [1]
template <bool by_angle>
[[gnu::always_inline]] inline Lit from_lamp_by_lobe(const Emitter& lamp, Real chosen, Color mirror, Real exponent,
                                                    const Hit& hit, vec3 n, vec3 to_viewer, vec2 u) {
    LightSample sample = light_sample(lamp, hit.point, u);
    if constexpr (by_angle) sample = by_angle_or(sample, lamp.quad, hit.point, u);
    sample.density *= chosen;
    const Real cosine = dot(n, sample.direction), of_lobe = lobe_density(exponent, sample.direction, n, to_viewer);
    // BRDF x cosine, from the density of the lobe, over the density of the lamp's point.
    const Real reflected = (exponent + 2) / (exponent + 1) * of_lobe * cosine / sample.density;
    const Real share = reflected * power_heuristic(sample.density, of_lobe);
    const Real seen = (bool(sample.density > 0) & bool(cosine > 0)) ? share : 0;
    return {seen * mirror * lamp.radiance, shadow_ray(hit, sample.direction, sample.distance)};
}

/// From a light without extent. A surface with a highlight is shaded by phong, any other by Lambert's law.
Lit from_point_light(const PointLight& lamp, const Material& m, const Hit& hit, vec3 n, vec3 to_viewer) {
    const vec3 to = lamp.directional ? lamp.position : lamp.position - hit.point;
    const Real distance = std::sqrt(dot(to, to));
    const vec3 to_light = to * (1 / distance);
    Color light;
    if (m.specular == Color(0))
        light = point_irradiance(lamp, hit.point, n) * m.albedo / pi;
    else
        light = phong(m, Color(0), point_irradiance(lamp, hit.point, to_light), n, to_light, to_viewer);
    return {light, shadow_ray(hit, to_light, lamp.directional ? inf : distance)};
}

/// From a direction of the environment.
[[gnu::always_inline]] inline Lit from_environment(Color radiance, Color albedo, const Hit& hit, vec3 n, vec2 u) {
    const DirectionSample sample = cosine_hemisphere(u);
    const Color light = sample.direction.z / (pi * sample.density) * albedo * radiance;
    return {light, shadow_ray(hit, frame_about(n).to_world(sample.direction), inf)};
}

template <bool highlights, bool by_angle, class L>
[[gnu::noinline]] void shine_on_surfaces(const L& lamps_in_memory, const Numbers& u, const Batch& b, const Surfaces& s,
                                         const Reflectances& reflectances, Batch& shadow, Colors& light) {
    const L lamps = lamps_in_memory;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        Material m;
        m.albedo = reflectances.albedo.at(i);
        if constexpr (highlights) m.specular = reflectances.specular.at(i), m.shininess = reflectances.shininess[i];
        const vec3 to_viewer = -b.direction.at(i);
        const Lit lit = from_lamp<by_angle>(lamps.at(i), lamps.chosen(i), m, s.hit(i), s.normal(i), to_viewer, u.at(i));
        light.set(i, lit.light);
        shadow.set_ray(i, lit.shadow);
    }
}

template <bool by_angle, class L>
[[gnu::noinline]] void shine_on_lobes(const L& lamps_in_memory, const Numbers& u, const Batch& b, const Surfaces& s,
                                      const Lobes& lobes, Batch& shadow, Colors& light) {
    const L lamps = lamps_in_memory;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Lit lit = from_lamp_by_lobe<by_angle>(lamps.at(i), lamps.chosen(i), lobes.mirror.at(i), lobes.exponent[i],
                                                    s.hit(i), s.normal(i), -b.direction.at(i), u.at(i));
        light.set(i, lit.light);
        shadow.set_ray(i, lit.shadow);
    }
}

[[gnu::noinline]] void environment_light(const World& world, const Numbers& u, const Surfaces& s,
                                         const Reflectances& reflectances, Batch& shadow, Colors& light) {
    const Color radiance = world.scene.environment;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Lit lit = from_environment(radiance, reflectances.albedo.at(i), s.hit(i), s.normal(i), u.at(i));
        light.set(i, lit.light);
        shadow.set_ray(i, lit.shadow);
    }
}

void point_light(const World& world, const PointLight& lamp, const Batch& b, const Surfaces& s, Batch& shadow,
                 Colors& light) {
    for (int i = 0; i < b.count; ++i) {
        Lit lit{Color(0), {vec3(0), vec3(0, 0, 1), 0, -inf}};
        if (s.material[i] != nothing) {
            const Material& m = world.scene.materials[std::size_t(s.material[i])];
            if (m.albedo != Color(0) || m.specular != Color(0))
                lit = from_point_light(lamp, m, s.hit(i), s.normal(i), -b.direction.at(i));
        }
        light.set(i, lit.light);
        shadow.set_ray(i, lit.shadow);
    }
}

void ambient_light(const World& world, const Batch& b, const Surfaces& s, Colors& found) {
    for (int i = 0; i < b.count; ++i) {
        if (s.material[i] == nothing) continue;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        if (m.ambient == Color(0)) continue;
        const vec3 n = s.normal(i);
        found.set(i, found.at(i) + b.weight.at(i) * phong(m, world.scene.ambient, Color(0), n, n, n));
    }
}

/// Dims what shadow rays carry by the medium in which their surfaces lie.
void dim(const World& world, const Batch& b, const Batch& shadow, Colors& light) {
    for (int i = 0; i < b.count; ++i) {
        const Index medium = world.regions.medium(b.inside[i]);
        if (medium == nothing || !(shadow.far[i] > 0)) continue;
        light.set(i, left_by(world.scene.materials[std::size_t(medium)].medium, shadow.far[i]) * light.at(i));
    }
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
        shadow.far[i] = wanted ? shadow.far[i] : -inf;
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

void direct_stage(const World& world, Pattern pattern, int wave, const Batch& b, const Surfaces& s, Batch& shadow,
                  Colors& found, Chunk& chunk) {
    if (world.scene.ambient != Color(0)) ambient_light(world, b, s, found);
    Reflectances reflectances;
    Lobes lobes;
    const bool reflects = look_up_reflectances(world, b.count, s, reflectances);
    const bool weighs = look_up_lobes(world, b, s, lobes);
    if (!reflects && !weighs) return;
    const bool through = world.plan.through;
    Colors light;
    for (int i = 0; i < lanes; ++i) shadow.time[i] = b.time[i];
    if (reflects)
        for (const PointLight& lamp : world.scene.lights) {
            point_light(world, lamp, b, s, shadow, light);
            send_shadow_rays(world, b, through, light, shadow, found, chunk);
        }
    Numbers u, choice;
    const auto draw = [&](int dimension) {
        draw_2d(pattern, wave_dimension(world, wave, dimension, pattern.n), b.key, b.sample, lanes, u);
    };
    const auto shine = [&](const auto& lamps, auto by_angle) {
        if (weighs) {
            shine_on_lobes<by_angle()>(lamps, u, b, s, lobes, shadow, light);
            // The lobe's rays find lamps behind such boundaries, and those count in full: their density is not known
            // there.
            send_shadow_rays(world, b, false, light, shadow, found, chunk);
        }
        if (!reflects) return;
        with_flag(world.plan.phong, [&](auto highlights) {
            shine_on_surfaces<highlights(), by_angle()>(lamps, u, b, s, reflectances, shadow, light);
        });
        send_shadow_rays(world, b, through, light, shadow, found, chunk);
    };
    if (world.plan.one_lamp) {
        draw(light_dimension);
        draw_1d(pattern, wave_dimension(world, wave, light_dimension + 1, pattern.n), b.key, b.sample, lanes, choice);
        with_chosen_lamps(world, s, b.count, choice, shine);
    } else {
        for (std::size_t l = 0; l < world.emitters.size(); ++l) {
            draw(light_dimension + int(l));
            with_lamp(world, world.emitters[l], shine);
        }
    }
    if (reflects && world.plan.environment_lit) {
        draw(environment_dimension);
        environment_light(world, u, s, reflectances, shadow, light);
        send_shadow_rays(world, b, through, light, shadow, found, chunk);
    }
}

}  // namespace rt
