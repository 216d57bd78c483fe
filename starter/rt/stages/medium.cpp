#include <algorithm>

#include "rt/fragments.h"
#include "rt/stages/stages.h"

namespace rt {
namespace {

/// Share of the light that a scattering turns from d to w, per solid angle [1/sr]: Henyey and Greenstein's phase
/// function.
Real phase(vec3 d, vec3 w, Real g) {
    const vec3 off = g < 0 ? d + w : d - w;  // from the peak: its square has more digits than d . w
    const Real h = std::abs(g), k = sqr(1 - h) + h * dot(off, off);
    return (1 - h) * (1 + h) / (4 * pi * k * std::sqrt(k));
}

}  // namespace

void medium_stage(const World& world, Pattern pattern, int wave, Batch& b, Queue& next, Chunk& chunk) {
    if (!world.plan.medium) return;
    const auto around = [&](Bits inside) { return world.regions.medium(inside); };
    if (std::all_of(b.inside, b.inside + b.count, [&](Bits inside) { return around(inside) == nothing; })) return;
    Numbers flight, turn;
    draw_1d(pattern, wave_dimension(world, wave, flight_dimension, pattern.n), b.key, b.sample, b.count, flight);
    draw_2d(pattern, wave_dimension(world, wave, phase_dimension, pattern.n), b.key, b.sample, b.count, turn);
    for (int i = 0; i < b.count; ++i) {
        const Index material = around(b.inside[i]);
        if (material == nothing) continue;
        const Medium& medium = world.scene.materials[std::size_t(material)].medium;
        const Real t = free_flight(medium.extinction, flight.x[i]);
        if (!(t < b.far[i])) continue;

        // The path goes on from here; what the ray would have met further on no longer matters.
        const Ray ray = b.ray(i);
        const DirectionSample way = scatter_direction(ray.direction, medium.g, turn.at(i));
        const Color weight =
            b.weight.at(i) * medium.albedo * (phase(ray.direction, way.direction, medium.g) / way.density);
        b.shape[i] = ended;
        if (weight == Color(0)) continue;
        const auto [to, j] = next.push();
        to.set_ray(j, {ray.origin + t * ray.direction, way.direction, 0, inf});
        to.time[j] = b.time[i];
        to.weight.set(j, weight);
        to.key[j] = b.key[i];
        to.sample[j] = b.sample[i];
        to.slot[j] = b.slot[i];
        to.event[j] = Index(Event::medium);
        to.depth[j] = b.depth[i];
        to.bounce[j] = b.bounce[i];
        to.inside[j] = b.inside[i];
        ++chunk.rays[int(RayKind::medium)];
    }
}

}  // namespace rt
