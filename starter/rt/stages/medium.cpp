#include <algorithm>

#include "rt/fragments.h"
#include "rt/lamps/importance.h"
#include "rt/media/phase.h"
#include "rt/stages/lamps.h"
#include "rt/stages/stages.h"

/// Random walks in media. Each scattering is lit straight from the lamps where shadow rays get out of the medium,
///
///     albedo phase(d, w) L / (p P)  times what the media leave of it if the shadow ray arrives, else 0
///
/// weighed against the ray that the scattering sends on, which may find the lamp too: as direct.cpp has it for lobes.
namespace rt {
namespace {

/// Where the lanes of a batch are scattered, and in the medium of which material; nothing: not.
struct Scatterings {
    Index material[lanes];
    Vectors<> point;
    Surfaces lit;  // those that shadow rays can leave

    const Medium& medium(const World& world, int i) const {
        return world.scene.materials[std::size_t(material[i])].medium;
    }
};

bool lights_media(const World& world, Index material) {
    return world.plan.media_lit && goes_straight_through(world.scene.materials[std::size_t(material)]);
}

/// Adds the light of one lamp for each lane.
template <bool by_angle, class L>
void shine_on_scatterings(const World& world, const L& lamps, const Numbers& u, const Batch& b, const Scatterings& at,
                          Batch& shadow, Colors& found, Chunk& chunk) {
    Colors light;
    Real of_lamp[lanes], of_phase[lanes];
    for (int i = 0; i < b.count; ++i) {
        shadow.time[i] = b.time[i];
        shadow.set_ray(i, {vec3(0), vec3(0, 0, 1), 0, -inf});
        of_phase[i] = 0;
        if (at.lit.material[i] == nothing || !(lamps.chosen(i) > 0)) continue;
        const Emitter lamp = lamps.at(i);
        LightSample sample = light_sample(lamp, at.point.at(i), u.at(i));
        if constexpr (by_angle) sample = by_angle_or(sample, lamp.quad, at.point.at(i), u.at(i));
        if (!(sample.density > 0)) continue;
        const Medium& medium = at.medium(world, i);
        of_lamp[i] = sample.density * lamps.chosen(i);
        of_phase[i] = phase(b.direction.at(i), sample.direction, medium.g);
        light.set(i, of_phase[i] / of_lamp[i] * medium.albedo * lamp.radiance);
        shadow.set_ray(i, shadow_ray({at.point.at(i), sample.direction}, sample.direction, sample.distance));
        ++chunk.rays[int(RayKind::shadow)];
    }
    Passed passed[lanes];
    shadow.count = b.count;
    through_stage(world, b.inside, shadow, light, passed);
    for (int i = 0; i < b.count; ++i) {
        if (!(of_phase[i] > 0) || shadow.shape[i] != nothing) continue;
        const Real by_path = passed[i].by_path(b.depth[i], world.scene.depth);
        const Real share = power_heuristic(of_lamp[i], of_phase[i] * by_path);
        found.set(i, found.at(i) + share * b.weight.at(i) * light.at(i));
    }
}

void light_scatterings(const World& world, Pattern pattern, int wave, const Batch& b, const Scatterings& at,
                       Batch& shadow, Colors& found, Chunk& chunk) {
    Numbers u, choice;
    const auto draw = [&](int dimension) {
        draw_2d(pattern, wave_dimension(world, wave, dimension, pattern.n), b.key, b.sample, b.count, u);
    };
    const auto shine = [&](const auto& lamps, auto by_angle) {
        shine_on_scatterings<by_angle()>(world, lamps, u, b, at, shadow, found, chunk);
    };
    if (world.plan.one_lamp) {
        draw(light_dimension);
        draw_1d(pattern, wave_dimension(world, wave, light_dimension + 1, pattern.n), b.key, b.sample, b.count, choice);
        with_chosen_lamps(world, at.lit, b.count, choice, shine);
        return;
    }
    for (std::size_t l = 0; l < world.emitters.size(); ++l) {
        draw(light_dimension + int(l));
        with_lamp(world, world.emitters[l], shine);
    }
}

/// Ends the lanes that are scattered. Returns whether any is, and whether any of them is to be lit.
std::pair<bool, bool> find_scatterings(const World& world, const Numbers& flight, Batch& b, Scatterings& at) {
    bool any = false, lit = false;
    for (int i = 0; i < b.count; ++i) {
        at.material[i] = at.lit.material[i] = nothing;
        const Index material = world.regions.medium(b.inside[i]);
        if (material == nothing) continue;
        const Real t = free_flight(world.scene.materials[std::size_t(material)].medium.extinction, flight.x[i]);
        if (!(t < b.far[i])) continue;
        // The path goes on from here; what the ray would have met further on no longer matters.
        b.shape[i] = ended;
        at.material[i] = material, any = true;
        at.point.set(i, b.origin.at(i) + t * b.direction.at(i));
        if (!lights_media(world, material)) continue;
        at.lit.material[i] = material, lit = true;
        at.lit.point.set(i, at.point.at(i));
    }
    return {any, lit};
}

/// Sends on the lanes that are scattered.
void send_on(const World& world, const Numbers& turn, const Numbers& chance, const Batch& b, const Scatterings& at,
             Queue& next, Chunk& chunk) {
    for (int i = 0; i < b.count; ++i) {
        if (at.material[i] == nothing) continue;
        const Medium& medium = at.medium(world, i);
        const vec3 before = b.direction.at(i);
        const DirectionSample way = scatter_direction(before, medium.g, turn.at(i));
        const Real density = phase(before, way.direction, medium.g);
        Color weight = b.weight.at(i) * medium.albedo * (density / way.density);
        if (world.plan.roulette) weight = after_roulette(weight, chance.x[i]);
        if (weight == Color(0)) continue;
        const auto [to, j] = next.push();
        to.set_ray(j, {at.point.at(i), way.direction, 0, inf});
        to.time[j] = b.time[i];
        to.weight.set(j, weight);
        to.key[j] = b.key[i];
        to.sample[j] = b.sample[i];
        to.slot[j] = b.slot[i];
        to.event[j] = Index(Event::medium);
        to.depth[j] = b.depth[i];
        to.bounce[j] = b.bounce[i];
        to.density[j] = at.lit.material[i] == nothing ? 0 : density;
        to.way[j] = 0;
        to.inside[j] = b.inside[i];
        ++chunk.rays[int(RayKind::medium)];
    }
}

}  // namespace

void medium_stage(const World& world, Pattern pattern, int wave, Batch& b, Batch& shadow, Queue& next, Colors& found,
                  Chunk& chunk) {
    if (!world.plan.medium) return;
    if (std::all_of(b.inside, b.inside + b.count, [&](Bits in) { return world.regions.medium(in) == nothing; })) return;
    Numbers flight, turn, chance;
    const auto dimension = [&](int of_wave) { return wave_dimension(world, wave, of_wave, pattern.n); };
    draw_1d(pattern, dimension(flight_dimension), b.key, b.sample, b.count, flight);
    Scatterings at;
    const auto [any, lit] = find_scatterings(world, flight, b, at);
    if (!any) return;
    if (lit) light_scatterings(world, pattern, wave, b, at, shadow, found, chunk);
    draw_2d(pattern, dimension(phase_dimension), b.key, b.sample, b.count, turn);
    if (world.plan.roulette) draw_1d(pattern, dimension(roulette_dimension), b.key, b.sample, b.count, chance);
    send_on(world, turn, chance, b, at, next, chunk);
}

}  // namespace rt
