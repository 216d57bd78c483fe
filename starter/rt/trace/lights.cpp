#include "rt/stages/scatter.h"
#include "rt/stages/weighed.h"
#include "rt/trace/words.h"

namespace rt {
namespace {

/// The lane that is told of.
struct Lane {
    const Wave& wave;
    int i;
    Told& told;

    const World& world() const { return wave.world; }
    const Material& material() const { return wave.material(i); }
    Hit hit() const { return wave.surfaces.hit(i); }
    vec3 normal() const { return wave.surfaces.normal(i); }
    vec3 to_viewer() const { return -wave.batch.direction.at(i); }
};

/// Sends the shadow ray, and adds the light if it arrives.
///
/// through  as the direct stage's
/// medium   none, or what has scattered the light, which is weighed then
void tell_shadow(const Lane& lane, const Lit& lit, vec3 to_light, bool through, const LitMedium* medium = nullptr) {
    Told& told = lane.told;
    const Ray& ray = lit.shadow;
    if (lit.light == Color(0)) return tell(told, "", "none, so no shadow ray is sent");
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
    if (!through && world.plan.medium) left.set(0, Color(left_around(world, inside, ray.far)));
    if (left.at(0) != Color(1)) tell(told, "medium", "leaves {} of it", text(left.at(0)));
    Color light = left.at(0) * lit.light;
    if (medium) {
        const Real share = medium->weight(passed, lane.wave.batch.depth[lane.i], world.scene.depth);
        tell(told, "", "weight against the ray that the scattering sends on {}", text(share));
        light = share * light;
    }
    tell_added(told, lane.wave.batch.weight.at(lane.i) * light);
}

void tell_point_light(const Lane& lane, const PointLight& lamp) {
    const Material& m = lane.material();
    const Hit hit = lane.hit();
    const Towards to = towards(lamp, hit.point);
    const Lit lit = from_point_light(lamp, m, hit, lane.normal(), lane.to_viewer());
    tell(lane.told, "to the light", "{}, {} away", text(to.direction), distance_text(to.distance));
    if (m.specular == Color(0)) {
        tell(lane.told, "point_irradiance", "{}, times albedo / pi: {}",
             text(point_irradiance(lamp, hit.point, lane.normal())), text(lit.light));
    } else {
        tell(lane.told, "point_irradiance", "{} on a surface that faces the light",
             text(point_irradiance(lamp, hit.point, to.direction)));
        tell(lane.told, "phong", "{}", text(lit.light));
    }
    tell_shadow(lane, lit, to.direction, lane.world().plan.through);
}

/// A point of a lamp. Its density is told by itself, and returned with the lamp's probability in it.
LightSample tell_point(const Lane& lane, const ChosenLamp& chosen, vec3 p, vec2 u) {
    LightSample sample = light_sample(chosen.lamp, p, u);
    adapt(sample, {chosen.lamp, 1, chosen.by_angle}, p, u);
    const bool wide = chosen.by_angle && seen_from(chosen.lamp.quad, p).is_wide();
    tell(lane.told, wide ? "by solid angle" : "light_sample", "u {}: point {}", text(u),
         text(p + sample.distance * sample.direction));
    tell(lane.told, "", "direction {}, distance {} m, density {} / sr", text(sample.direction), text(sample.distance),
         text(sample.density));
    sample.density *= chosen.probability;
    return sample;
}

/// What a glossy lobe reflects of a lamp, weighed against the rays of the lobe.
void tell_lobe(const Lane& lane, const ChosenLamp& chosen, const LightSample& sample, vec2 u) {
    const Material& m = lane.material();
    const vec3 n = lane.normal(), to_viewer = lane.to_viewer();
    const Color mirror = outgoing(m, lane.wave.batch, lane.wave.surfaces, lane.i).mirror;
    const Lit lit = from_lamp_by_lobe(chosen, mirror, m.exponent, lane.hit(), n, to_viewer, u);
    const Real of_lobe = lobe_density(m.exponent, sample.direction, n, to_viewer);
    tell(lane.told, "lobe", "density {} / sr, weight against the lobe's rays {}: {}", text(of_lobe),
         text(power_heuristic(sample.density, of_lobe)), text(lit.light));
    tell_shadow(lane, lit, sample.direction, false);
}

/// With what direct_light reads of a material.
void tell_surface(const Lane& lane, const ChosenLamp& chosen, const LightSample& sample, vec2 u) {
    Material m;
    m.albedo = lane.material().albedo;
    if (lane.world().plan.phong) m.specular = lane.material().specular, m.shininess = lane.material().shininess;
    const Lit lit = from_lamp(chosen, m, lane.hit(), lane.normal(), lane.to_viewer(), u);
    tell(lane.told, "direct_light", "{}", text(lit.light));
    tell_shadow(lane, lit, sample.direction, lane.world().plan.through);
}

void tell_lamp(const Lane& lane, std::size_t number, const ChosenLamp& chosen, vec2 u) {
    const World& world = lane.world();
    const Material& m = lane.material();
    const bool weighs = world.plan.weigh &&
                        world.reflectances[std::size_t(lane.wave.surfaces.material[lane.i]) + 1].lobe &&
                        lane.wave.batch.depth[lane.i] < world.scene.depth;
    const bool reflects = m.albedo != Color(0) || m.specular != Color(0);
    if (!weighs && !reflects) return;
    lane.told.text += world.plan.one_lamp
                          ? fmt::format("  lamp {}, chosen with probability {}\n", number, text(chosen.probability))
                          : fmt::format("  lamp {}\n", number);
    const LightSample sample = tell_point(lane, chosen, lane.hit().point, u);
    if (weighs) tell_lobe(lane, chosen, sample, u);
    if (reflects) tell_surface(lane, chosen, sample, u);
}

void tell_environment(const Lane& lane) {
    lane.told.text += "  the environment\n";
    const vec2 u = numbers_of(lane.wave, lane.i, environment_dimension);
    const Lit lit =
        from_environment(lane.world().scene.environment, lane.material().albedo, lane.hit(), lane.normal(), u);
    const DirectionSample sample = cosine_hemisphere(u);
    const vec3 direction = frame_about(lane.normal()).to_world(sample.direction);
    tell(lane.told, "cosine_hemisphere", "u {}: {} about the normal, density {} / sr", text(u), text(sample.direction),
         text(sample.density));
    tell(lane.told, "", "in the world {}: {}", text(direction), text(lit.light));
    tell_shadow(lane, lit, direction, lane.world().plan.through);
}

/// The light of a lamp that a medium scatters.
void tell_scattered(const Lane& lane, vec3 point, const Medium& medium, std::size_t number, const ChosenLamp& chosen,
                    vec2 u) {
    lane.told.text += fmt::format("  lamp {}\n", number);
    const LightSample sample = tell_point(lane, chosen, point, u);
    const LitMedium scattered = from_lamp_by_medium(chosen, medium, point, lane.wave.batch.direction.at(lane.i), u);
    tell(lane.told, "medium", "scatters {}", text(scattered.lit.light));
    tell_shadow(lane, scattered.lit, sample.direction, true, &scattered);
}

/// Calls f with each lamp that is sampled at a point, its number and random numbers.
template <class F>
void with_lamps_for(const Lane& lane, vec3 point, F f) {
    const World& world = lane.world();
    const auto with = [&](std::size_t number, Real probability, int dimension) {
        const Emitter& lamp = world.emitters[number];
        const bool by_angle = lamp.kind == Emitter::Kind::quad && world.plan.solid_angle;
        f(number, ChosenLamp{lamp, probability, by_angle}, numbers_of(lane.wave, lane.i, dimension));
    };
    if (world.plan.one_lamp) {
        const Real u = number_of(lane.wave, lane.i, light_dimension + 1);
        const LampTree::Choice chosen = world.lamp_tree.choose(point, u);
        with(chosen.lamp, chosen.probability, light_dimension);
    } else if (world.plan.light) {
        for (std::size_t l = 0; l < world.emitters.size(); ++l) with(l, 1, light_dimension + int(l));
    }
}

}  // namespace

void trace_scattered(const Wave& wave, int i, Index material, vec3 point, Told& told) {
    const Material& m = wave.world.scene.materials[std::size_t(material)];
    if (!wave.world.plan.media_lit || !goes_straight_through(m)) return;
    const Lane lane{wave, i, told};
    with_lamps_for(lane, point, [&](std::size_t number, const ChosenLamp& chosen, vec2 u) {
        tell_scattered(lane, point, m.medium, number, chosen, u);
    });
}

void trace_lights(const Wave& wave, int i, Told& told) {
    const World& world = wave.world;
    const Lane lane{wave, i, told};
    const Material& m = lane.material();
    if (world.scene.ambient != Color(0) && m.ambient != Color(0)) {
        const Color light = from_ambient_light(world.scene.ambient, m, lane.normal());
        tell(told, "phong", "of ambient light: {}", text(light));
        tell_added(told, wave.batch.weight.at(i) * light);
    }
    if (m.albedo != Color(0) || m.specular != Color(0))
        for (std::size_t k = 0; k < world.scene.lights.size(); ++k) {
            told.text += fmt::format("  light {}\n", k);
            tell_point_light(lane, world.scene.lights[k]);
        }
    with_lamps_for(lane, lane.hit().point,
                   [&](std::size_t number, const ChosenLamp& chosen, vec2 u) { tell_lamp(lane, number, chosen, u); });
    if (world.plan.environment_lit && m.albedo != Color(0) && !bounces_to_sky(world, wave.batch, i))
        tell_environment(lane);
}

}  // namespace rt
