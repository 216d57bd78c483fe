#include "rt/lamps/importance.h"
#include "rt/stages/lamps.h"

namespace rt {
namespace {

/// What the direct stage reads of a material, gathered for each lane.
struct alignas(64) Reflectances {
    Real albedo_r[lanes], albedo_g[lanes], albedo_b[lanes];
    Real specular_r[lanes], specular_g[lanes], specular_b[lanes], shininess[lanes];  // where there are highlights

    Color albedo(int i) const { return {albedo_r[i], albedo_g[i], albedo_b[i]}; }
    Color specular(int i) const { return {specular_r[i], specular_g[i], specular_b[i]}; }
};

/// Dims what shadow rays carry by the medium in which their surfaces lie.
void dim(const World& world, const Batch& b, const Batch& shadow, Colors& light) {
    for (int i = 0; i < b.count; ++i) {
        const Index medium = world.regions.medium(b.inside[i]);
        if (medium == nothing || !(shadow.far[i] > 0)) continue;
        light.set(i, left_by(world.scene.materials[std::size_t(medium)].medium, shadow.far[i]) * light.at(i));
    }
}

/// Adds reflected light where the shadow ray met nothing, and counts the shadow rays.
///
/// through  whether boundaries that bend no light let the rays pass
[[gnu::noinline]] void gather(const World& world, const Batch& b, bool through, Colors& light, Batch& shadow, Colors& found,
                              Chunk& chunk) {
    Index sent = 0;
    for (Index i = 0; i < lanes; ++i) {
        const bool wanted = bool(light.r[i] != 0) | bool(light.g[i] != 0) | bool(light.b[i] != 0);
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
        const bool lit = shadow.shape[i] == nothing;
        found.r[i] += lit ? b.weight_r[i] * light.r[i] : 0;
        found.g[i] += lit ? b.weight_g[i] * light.g[i] : 0;
        found.b[i] += lit ? b.weight_b[i] * light.b[i] : 0;
    }
    chunk.rays[int(RayKind::shadow)] += std::uint64_t(sent);
}

/// Light without extent. A surface with a highlight is shaded by phong, any other by Lambert's law.
void point_light(const World& world, const PointLight& light_in_memory, const Batch& b, const Surfaces& s,
                 Batch& shadow, Colors& light) {
    const PointLight lamp = light_in_memory;
    for (int i = 0; i < b.count; ++i) {
        light.set(i, Color(0));
        shadow.set_ray(i, {vec3(0), vec3(0, 0, 1), 0, -inf});
        if (s.material[i] == nothing) continue;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        if (m.albedo == Color(0) && m.specular == Color(0)) continue;
        const Hit hit = s.hit(i);
        const vec3 n = s.normal(i);
        const vec3 to = lamp.directional ? lamp.position : lamp.position - hit.point;
        const Real distance = std::sqrt(dot(to, to));
        const vec3 to_light = to * (1 / distance);
        if (m.specular == Color(0)) {
            light.set(i, point_irradiance(lamp, hit.point, n) * m.albedo / pi);
        } else {
            const vec3 to_viewer = -vec3(b.dx[i], b.dy[i], b.dz[i]);
            light.set(i, phong(m, Color(0), point_irradiance(lamp, hit.point, to_light), n, to_light, to_viewer));
        }
        shadow.set_ray(i, shadow_ray(hit, to_light, lamp.directional ? inf : distance));
    }
}

/// One sample of a light with extent for each lane.
template <bool highlights, By by, class L>
[[gnu::noinline]] void area_light(const L& lamps_in_memory, const Numbers& u, const Batch& b, const Surfaces& s,
                const Reflectances& reflectances, Batch& shadow, Colors& light) {
    const L lamps = lamps_in_memory;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Hit hit = s.hit(i);
        const vec3 normal = s.normal(i), to_viewer = -vec3(b.dx[i], b.dy[i], b.dz[i]);
        LightSample sample = sample_light<by>(lamps.at(i), hit.point, u.at(i));
        sample.density *= lamps.chosen(i);
        Material material;
        material.albedo = reflectances.albedo(i);
        if constexpr (highlights) {
            material.specular = reflectances.specular(i);
            material.shininess = reflectances.shininess[i];
        }
        light.set(i, direct_light(material, lamps.radiance(i), sample, normal, to_viewer));
        shadow.set_ray(i, shadow_ray(hit, sample.direction, sample.distance));
    }
}

/// What glossy lobes reflect to the viewer, gathered for each lane; black where there is none.
struct alignas(64) Lobes {
    Real r[lanes], g[lanes], b[lanes], exponent[lanes];
};

/// One sample of a light with extent for each lane with a glossy lobe, weighed against the rays of the lobe.
template <By by, class L>
[[gnu::noinline]] void weighed_light(const L& lamps_in_memory, const Numbers& u, const Batch& b, const Surfaces& s,
                                     const Lobes& lobes, Batch& shadow, Colors& light) {
    const L lamps = lamps_in_memory;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Hit hit = s.hit(i);
        const vec3 normal = s.normal(i), to_viewer = -vec3(b.dx[i], b.dy[i], b.dz[i]);
        LightSample sample = sample_light<by>(lamps.at(i), hit.point, u.at(i));
        sample.density *= lamps.chosen(i);
        const Real exponent = lobes.exponent[i], cosine = dot(normal, sample.direction);
        const Real of_lobe = lobe_density(exponent, sample.direction, normal, to_viewer);
        // BRDF x cosine, from the density of the lobe, over the density of the lamp's point.
        const Real reflected = (exponent + 2) / (exponent + 1) * of_lobe * cosine / sample.density;
        const Real share = reflected * power_heuristic(sample.density, of_lobe);
        const Real seen = (bool(sample.density > 0) & bool(cosine > 0)) ? share : 0;
        const Color radiance = lamps.radiance(i);
        light.r[i] = seen * lobes.r[i] * radiance.x, light.g[i] = seen * lobes.g[i] * radiance.y,
        light.b[i] = seen * lobes.b[i] * radiance.z;
        shadow.set_ray(i, shadow_ray(hit, sample.direction, sample.distance));
    }
}

/// One direction of the environment for each lane.
void environment_light(const World& world, const Numbers& u, const Surfaces& s, const Reflectances& reflectances,
                       Batch& shadow, Colors& light) {
    const Color radiance = world.scene.environment;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const DirectionSample sample = cosine_hemisphere(u.at(i));
        const vec3 direction = frame_about(s.normal(i)).to_world(sample.direction);
        const Real over = sample.direction.z / (pi * sample.density);
        light.set(i, over * reflectances.albedo(i) * radiance);
        shadow.set_ray(i, shadow_ray(s.hit(i), direction, inf));
    }
}

/// Reflectances of the lanes' materials; black where there is no surface. Returns whether any lane reflects.
bool gather_reflectances(const World& world, int count, const Surfaces& s, Reflectances& r) {
    const Reflectance* table = world.reflectances.data();
    const Index last = count;
    Index any = 0;
    for (Index i = 0; i < lanes; ++i) {
        const Reflectance& m = table[i < last ? s.material[i] + 1 : 0];
        any |= m.reflects;
        r.albedo_r[i] = m.albedo.x, r.albedo_g[i] = m.albedo.y, r.albedo_b[i] = m.albedo.z;
    }
    if (!world.plan.phong) return any != 0;
    for (Index i = 0; i < lanes; ++i) {
        const Reflectance& m = table[i < last ? s.material[i] + 1 : 0];
        r.specular_r[i] = m.specular.x, r.specular_g[i] = m.specular.y, r.specular_b[i] = m.specular.z;
        r.shininess[i] = m.shininess;
    }
    return any != 0;
}

/// The lobes of the lanes' materials whose rays go on, where lamps are weighed against them. Returns whether there is any.
bool gather_lobes(const World& world, const Batch& b, const Surfaces& s, Lobes& lobes) {
    if (!world.plan.weigh) return false;
    const Reflectance* table = world.reflectances.data();
    const Index last = b.count, depth = world.scene.depth;
    Index lobe[lanes], any = 0;
    for (Index i = 0; i < lanes; ++i) {
        lobe[i] = table[i < last ? s.material[i] + 1 : 0].lobe & (b.depth[i] < depth);
        any |= lobe[i];
    }
    if (!any) return false;
    lobes = {};
    for (int i = 0; i < b.count; ++i) {
        if (!lobe[i]) continue;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        const Color mirror = outgoing(m, b, s, i).mirror;
        lobes.r[i] = mirror.x, lobes.g[i] = mirror.y, lobes.b[i] = mirror.z, lobes.exponent[i] = m.exponent;
    }
    return true;
}

void ambient_light(const World& world, const Batch& b, const Surfaces& s, Colors& found) {
    for (int i = 0; i < b.count; ++i) {
        if (s.material[i] == nothing) continue;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        if (m.ambient == Color(0)) continue;
        const vec3 n = s.normal(i);
        found.set(i, found.at(i) + b.weight(i) * phong(m, world.scene.ambient, Color(0), n, n, n));
    }
}

}  // namespace

void direct_stage(const World& world, Pattern pattern, int wave, const Batch& b, const Surfaces& s,
                  Batch& shadow, Colors& found, Chunk& chunk) {
    if (world.scene.ambient != Color(0)) ambient_light(world, b, s, found);
    Reflectances reflectances;
    Lobes lobes;
    const bool reflects = gather_reflectances(world, b.count, s, reflectances);
    const bool weighs = gather_lobes(world, b, s, lobes);
    if (!reflects && !weighs) return;
    const bool through = world.plan.through;
    Colors light;
    for (int i = 0; i < lanes; ++i) shadow.time[i] = b.time[i];
    if (reflects)
        for (const PointLight& lamp : world.scene.lights) {
            point_light(world, lamp, b, s, shadow, light);
            gather(world, b, through, light, shadow, found, chunk);
        }
    Numbers u, choice;
    const auto shine = [&](const auto& lamps, auto by) {
        if (weighs) {
            weighed_light<by()>(lamps, u, b, s, lobes, shadow, light);
            // The lobe's rays find lamps behind such boundaries, and those count in full: their density is not known there.
            gather(world, b, false, light, shadow, found, chunk);
        }
        if (!reflects) return;
        with_flag(world.plan.phong, [&](auto highlights) {
            area_light<highlights(), by()>(lamps, u, b, s, reflectances, shadow, light);
        });
        gather(world, b, through, light, shadow, found, chunk);
    };
    const auto draw_point = [&](int l) {
        draw_2d(pattern, wave_dimension(world, wave, light_dimension + l, pattern.n), b.key, b.sample, lanes, u);
    };
    if (world.plan.one_lamp) {
        draw_point(0);
        draw_1d(pattern, wave_dimension(world, wave, light_dimension + 1, pattern.n), b.key, b.sample, lanes, choice);
        with_chosen_lamps(world, s, b.count, choice, shine);
    } else {
        for (std::size_t l = 0; l < world.emitters.size(); ++l) {
            draw_point(int(l));
            with_lamp(world, world.emitters[l], shine);
        }
    }
    if (reflects && world.plan.environment_lit) {
        draw_2d(pattern, wave_dimension(world, wave, environment_dimension, pattern.n), b.key, b.sample, lanes, u);
        environment_light(world, u, s, reflectances, shadow, light);
        gather(world, b, through, light, shadow, found, chunk);
    }
}

}  // namespace rt
