#include "rt/lamps/importance.h"
#include "rt/media/phase.h"
#include "rt/stages/scatter.h"
#include "rt/trace/words.h"

namespace rt {
namespace {

/// The lane that is told of.
struct Lane {
    const Wave& wave;
    int i;
    Told& told;

    const World& world() const { return wave.world; }
    const Material& material() const { return world().scene.materials[std::size_t(wave.surfaces.material[i])]; }
    Hit hit() const { return wave.surfaces.hit(i); }
    vec3 normal() const { return wave.surfaces.normal(i); }
    vec3 to_viewer() const { return -wave.batch.direction.at(i); }
    vec2 numbers(int dimension) const {
        Numbers u;
        draw_2d(wave.pattern, wave_dimension(world(), wave.number, dimension, wave.pattern.n), wave.batch.key,
                wave.batch.sample, wave.batch.count, u);
        return u.at(i);
    }
};

/// With which densities a lamp's point and a scattering take a direction.
struct OfMedium {
    Real of_lamp, of_phase;  // [1/sr]
};

/// Sends the shadow ray, and adds the light if it arrives.
///
/// through  as the direct stage's
/// weights  none, or what light is weighed by that a medium scatters
void tell_shadow(const Lane& lane, const Ray& ray, vec3 to_light, bool through, Color light,
                 std::optional<OfMedium> weights = std::nullopt) {
    Told& told = lane.told;
    if (light == Color(0)) return tell(told, "", "none, so no shadow ray is sent");
    const std::string along = ray.direction == to_light ? "" : fmt::format(" along {}", text(ray.direction));
    const std::string sent = fmt::format("from {}{} to {}", text(ray.origin), along, distance_text(ray.far));
    Batch shadow{};
    shadow.count = 1;
    shadow.set_ray(0, ray);
    shadow.time[0] = lane.wave.batch.time[lane.i];
    const World& world = lane.world();
    const Bits inside = lane.wave.batch.inside[lane.i];
    Colors left;
    Passed passed;
    left.set(0, Color(1));
    through ? through_stage(world, &inside, shadow, left, &passed) : any_hit_stage(world, shadow);
    if (shadow.shape[0] != nothing) {
        const Index id = shadow.shape[0];
        return tell(told, "shadow_ray", "{}: stopped by shape {} ({}) at {} m", sent, id, hit_name(world, id),
                    text(shadow.far[0]));
    }
    tell(told, "shadow_ray", "{}: arrives", sent);
    const Index medium = world.plan.medium ? world.regions.medium(inside) : nothing;
    if (!through && medium != nothing)
        left.set(0, Color(left_by(world.scene.materials[std::size_t(medium)].medium, ray.far)));
    if (left.at(0) != Color(1)) tell(told, "medium", "leaves {} of it", text(left.at(0)));
    light = left.at(0) * light;
    if (weights) {
        const Real by_path = passed.by_path(lane.wave.batch.depth[lane.i], world.scene.depth);
        const Real share = power_heuristic(weights->of_lamp, weights->of_phase * by_path);
        tell(told, "", "weight against the ray that the scattering sends on {}", text(share));
        light = share * light;
    }
    tell_added(told, lane.wave.batch.weight.at(lane.i) * light);
}

void tell_point_light(const Lane& lane, const PointLight& lamp) {
    const Material& m = lane.material();
    const Hit hit = lane.hit();
    const vec3 n = lane.normal(), to = lamp.directional ? lamp.position : lamp.position - hit.point;
    const Real distance = std::sqrt(dot(to, to));
    const vec3 to_light = to * (1 / distance);
    Color light;
    tell(lane.told, "to the light", "{}, {} away", text(to_light), distance_text(lamp.directional ? inf : distance));
    if (m.specular == Color(0)) {
        const Color irradiance = point_irradiance(lamp, hit.point, n);
        light = irradiance * m.albedo / pi;
        tell(lane.told, "point_irradiance", "{}, times albedo / pi: {}", text(irradiance), text(light));
    } else {
        const Color irradiance = point_irradiance(lamp, hit.point, to_light);
        light = phong(m, Color(0), irradiance, n, to_light, lane.to_viewer());
        tell(lane.told, "point_irradiance", "{} on a surface that faces the light", text(irradiance));
        tell(lane.told, "phong", "{}", text(light));
    }
    tell_shadow(lane, shadow_ray(hit, to_light, lamp.directional ? inf : distance), to_light, lane.world().plan.through,
                light);
}

/// A point of a lamp, as the direct stage finds it.
LightSample tell_point(const Lane& lane, const Emitter& lamp, vec3 p, vec2 u) {
    const bool by_angle = lamp.kind == Emitter::Kind::quad && lane.world().plan.solid_angle;
    const LightSample by_area = light_sample(lamp, p, u);
    const LightSample sample = by_angle ? by_angle_or(by_area, lamp.quad, p, u) : by_area;
    const bool wide = by_angle && seen_from(lamp.quad, p).is_wide();
    tell(lane.told, wide ? "by solid angle" : "light_sample", "u {}: point {}", text(u),
         text(p + sample.distance * sample.direction));
    tell(lane.told, "", "direction {}, distance {} m, density {} / sr", text(sample.direction), text(sample.distance),
         text(sample.density));
    return sample;
}

/// What a glossy lobe reflects of a lamp, weighed against the rays of the lobe.
Color tell_lobe(const Lane& lane, const Emitter& lamp, const LightSample& sample) {
    const Material& m = lane.material();
    const Color mirror = outgoing(m, lane.wave.batch, lane.wave.surfaces, lane.i).mirror;
    const Real cosine = dot(lane.normal(), sample.direction);
    const Real of_lobe = lobe_density(m.exponent, sample.direction, lane.normal(), lane.to_viewer());
    const Real reflected = (m.exponent + 2) / (m.exponent + 1) * of_lobe * cosine / sample.density;
    const Real weight = power_heuristic(sample.density, of_lobe);
    const Real share = sample.density > 0 && cosine > 0 ? reflected * weight : 0;
    const Color light = share * mirror * lamp.radiance;
    tell(lane.told, "lobe", "density {} / sr, weight against the lobe's rays {}: {}", text(of_lobe), text(weight),
         text(light));
    return light;
}

/// What direct_light reads of a material.
Color tell_direct_light(const Lane& lane, const Emitter& lamp, const LightSample& sample) {
    Material m;
    m.albedo = lane.material().albedo;
    if (lane.world().plan.phong) m.specular = lane.material().specular, m.shininess = lane.material().shininess;
    const Color light = direct_light(m, lamp.radiance, sample, lane.normal(), lane.to_viewer());
    tell(lane.told, "direct_light", "{}", text(light));
    return light;
}

void tell_lamp(const Lane& lane, std::size_t lamp, Real probability, vec2 u) {
    const World& world = lane.world();
    const Material& m = lane.material();
    const bool weighs = world.plan.weigh &&
                        world.reflectances[std::size_t(lane.wave.surfaces.material[lane.i]) + 1].lobe &&
                        lane.wave.batch.depth[lane.i] < world.scene.depth;
    const bool reflects = m.albedo != Color(0) || m.specular != Color(0);
    if (!weighs && !reflects) return;
    lane.told.text += world.plan.one_lamp
                          ? fmt::format("  lamp {}, chosen with probability {}\n", lamp, text(probability))
                          : fmt::format("  lamp {}\n", lamp);
    const Emitter& emitter = world.emitters[lamp];
    LightSample sample = tell_point(lane, emitter, lane.hit().point, u);
    sample.density *= probability;
    const Ray ray = shadow_ray(lane.hit(), sample.direction, sample.distance);
    if (weighs) tell_shadow(lane, ray, sample.direction, false, tell_lobe(lane, emitter, sample));
    if (reflects)
        tell_shadow(lane, ray, sample.direction, world.plan.through, tell_direct_light(lane, emitter, sample));
}

void tell_environment(const Lane& lane) {
    lane.told.text += "  the environment\n";
    const vec2 u = lane.numbers(environment_dimension);
    const DirectionSample sample = cosine_hemisphere(u);
    const vec3 direction = frame_about(lane.normal()).to_world(sample.direction);
    const Color light =
        sample.direction.z / (pi * sample.density) * lane.material().albedo * lane.world().scene.environment;
    tell(lane.told, "cosine_hemisphere", "u {}: {} about the normal, density {} / sr", text(u), text(sample.direction),
         text(sample.density));
    tell(lane.told, "", "in the world {}: {}", text(direction), text(light));
    tell_shadow(lane, shadow_ray(lane.hit(), direction, inf), direction, lane.world().plan.through, light);
}

/// The light of a lamp that a medium scatters.
void tell_scattered(const Lane& lane, vec3 point, const Medium& medium, std::size_t lamp, Real probability, vec2 u) {
    const Batch& b = lane.wave.batch;
    const Emitter& emitter = lane.world().emitters[lamp];
    lane.told.text += fmt::format("  lamp {}\n", lamp);
    const LightSample sample = tell_point(lane, emitter, point, u);
    const OfMedium weights{sample.density * probability, phase(b.direction.at(lane.i), sample.direction, medium.g)};
    const Color light =
        sample.density > 0 ? weights.of_phase / weights.of_lamp * medium.albedo * emitter.radiance : Color(0);
    tell(lane.told, "medium", "scatters {}", text(light));
    tell_shadow(lane, shadow_ray({point, sample.direction}, sample.direction, sample.distance), sample.direction, true,
                light, weights);
}

/// Calls f with each lamp that is sampled at a point, its probability and random numbers.
template <class F>
void with_lamps_for(const Lane& lane, vec3 point, F f) {
    const Wave& wave = lane.wave;
    const World& world = wave.world;
    if (world.plan.one_lamp) {
        Numbers choice;
        draw_1d(wave.pattern, wave_dimension(world, wave.number, light_dimension + 1, wave.pattern.n), wave.batch.key,
                wave.batch.sample, wave.batch.count, choice);
        const LampTree::Choice chosen = world.lamp_tree.choose(point, choice.x[lane.i]);
        f(chosen.lamp, chosen.probability, lane.numbers(light_dimension));
    } else if (world.plan.light) {
        for (std::size_t l = 0; l < world.emitters.size(); ++l) f(l, 1, lane.numbers(light_dimension + int(l)));
    }
}

}  // namespace

void trace_scattered(const Wave& wave, int i, Index material, vec3 point, Told& told) {
    const Material& m = wave.world.scene.materials[std::size_t(material)];
    if (!wave.world.plan.media_lit || !goes_straight_through(m)) return;
    const Lane lane{wave, i, told};
    with_lamps_for(lane, point, [&](std::size_t lamp, Real probability, vec2 u) {
        tell_scattered(lane, point, m.medium, lamp, probability, u);
    });
}

void trace_lights(const Wave& wave, int i, Told& told) {
    const World& world = wave.world;
    const Lane lane{wave, i, told};
    const Material& m = lane.material();
    if (world.scene.ambient != Color(0) && m.ambient != Color(0)) {
        const vec3 n = lane.normal();
        const Color light = phong(m, world.scene.ambient, Color(0), n, n, n);
        tell(told, "phong", "of ambient light: {}", text(light));
        tell_added(told, wave.batch.weight.at(i) * light);
    }
    if (m.albedo != Color(0) || m.specular != Color(0))
        for (std::size_t k = 0; k < world.scene.lights.size(); ++k) {
            told.text += fmt::format("  light {}\n", k);
            tell_point_light(lane, world.scene.lights[k]);
        }
    with_lamps_for(lane, lane.hit().point,
                   [&](std::size_t lamp, Real probability, vec2 u) { tell_lamp(lane, lamp, probability, u); });
    if (world.plan.environment_lit && m.albedo != Color(0)) tell_environment(lane);
}

}  // namespace rt
