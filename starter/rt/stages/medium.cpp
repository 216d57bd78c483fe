#include <algorithm>

#include "rt/stages/weighed.h"

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
template <class L>
void shine_on_scatterings(const Wave& wave, const L& lamps, const Numbers& u, const Scatterings& at, Batch& shadow,
                          Colors& found, Chunk& chunk) {
    const World& world = wave.world;
    const Batch& b = wave.batch;
    Colors light;
    LitMedium scattered[lanes];
    for (int i = 0; i < b.count; ++i) {
        if (at.lit.material[i] != nothing && lamps.chosen(i) > 0)
            scattered[i] =
                from_lamp_by_medium(lamps.at(i), at.medium(world, i), at.point.at(i), b.direction.at(i), u.at(i));
        shadow.time[i] = b.time[i];
        shadow.set_ray(i, scattered[i].lit.shadow);
        light.set(i, scattered[i].lit.light);
        chunk.rays[int(RayKind::shadow)] += scattered[i].of_lamp > 0;
    }
    Passed passed[lanes];
    shadow.count = b.count;
    through_stage(world, b.inside, shadow, light, passed);
    for (int i = 0; i < b.count; ++i) {
        if (!(scattered[i].of_phase > 0) || shadow.shape[i] != nothing) continue;
        const Real share = scattered[i].weight(passed[i], b.depth[i], world.scene.depth);
        found.set(i, found.at(i) + share * b.weight.at(i) * light.at(i));
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
        to.continue_path(j, b, i);
        to.set_ray(j, {at.point.at(i), way.direction, 0, inf});
        to.weight.set(j, weight);
        to.event[j] = Index(Event::medium);
        to.density[j] = at.lit.material[i] == nothing ? 0 : density;
        to.way[j] = 0;
        ++chunk.rays[int(RayKind::medium)];
    }
}

}  // namespace

void medium_stage(const Wave& wave, Batch& b, Batch& shadow, Queue& next, Colors& found, Chunk& chunk) {
    const World& world = wave.world;
    if (!world.plan.medium) return;
    if (std::all_of(b.inside, b.inside + b.count, [&](Bits in) { return world.regions.medium(in) == nothing; })) return;
    Numbers flight, turn, chance;
    wave.draw_1d(flight_dimension, b.count, flight);
    Scatterings at;
    const auto [any, lit] = find_scatterings(world, flight, b, at);
    if (!any) return;
    if (lit)
        for_each_lamp(wave, at.lit, b.count, [&](const auto& lamps, const Numbers& u) {
            shine_on_scatterings(wave, lamps, u, at, shadow, found, chunk);
        });
    wave.draw_2d(phase_dimension, b.count, turn);
    if (world.plan.roulette) wave.draw_1d(roulette_dimension, b.count, chance);
    send_on(world, turn, chance, b, at, next, chunk);
}

}  // namespace rt
