#include "rt/fragments.h"
#include "rt/lamps/importance.h"
#include "rt/stages/stages.h"

namespace rt {
namespace {

/// What rays that meet nothing see: the environment, and the background if they come from the camera.
template <bool counts_twice>
void see_sky(const World& world, const Batch& b, Colors& found) {
    const Color environment = world.scene.environment, background = world.scene.background;
    const bool lit = world.plan.environment_lit;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Event from = Event(b.event[i]);
        const bool counts = !counts_twice || emission_counts(from, lit), camera = from == Event::camera;
        const Color light{(counts ? environment.x : 0) + (camera ? background.x : 0),
                          (counts ? environment.y : 0) + (camera ? background.y : 0),
                          (counts ? environment.z : 0) + (camera ? background.z : 0)};
        const bool missed = b.shape[i] == nothing;
        found.x[i] += missed ? b.weight.x[i] * light.x : 0;
        found.y[i] += missed ? b.weight.y[i] * light.y : 0;
        found.z[i] += missed ? b.weight.z[i] * light.z : 0;
    }
}

void see_emitters(const World& world, const Batch& b, const Surfaces& s, Colors& found) {
    Index any = 0;
    for (int i = 0; i < lanes; ++i) any |= s.shines[i];
    if (!any) return;
    for (int i = 0; i < b.count; ++i) {
        if (!s.shines[i]) continue;
        const SurfaceRecord& lamp = world.surfaces[std::size_t(b.shape[i])];
        const bool sampled = lamp.emitter != nothing;
        if (world.plan.counts_twice && !emission_counts(Event(b.event[i]), sampled)) continue;
        const Real share = share_of_found(world, lamp, b, i).value_or(1);
        found.set(i, found.at(i) + share * b.weight.at(i) * world.scene.materials[std::size_t(s.material[i])].emission);
    }
}

}  // namespace

std::optional<Real> share_of_found(const World& world, const SurfaceRecord& lamp, const Batch& b, int i) {
    const Event from = Event(b.event[i]);
    const bool of_medium = world.plan.media_lit && from == Event::medium,
               of_lobe = world.plan.weigh && from == Event::lobe;
    if (lamp.emitter == nothing || !(of_medium || of_lobe) || !(b.density[i] > 0)) return std::nullopt;
    Ray ray = b.ray(i);
    if (of_lobe) return power_heuristic(b.density[i], light_density(world, lamp, ray, b.far[i]));
    ray.origin -= b.way[i] * ray.direction;
    return power_heuristic(b.density[i] * left_around(world, b.inside[i], b.far[i]),
                           light_density(world, lamp, ray, b.way[i] + b.far[i]));
}

void emission_stage(const World& world, const Batch& batch, const Surfaces& surfaces, Colors& found) {
    const RenderPlan& plan = world.plan;
    if (plan.environment || world.scene.background != Color(0))
        with_flag(plan.counts_twice && !plan.sky_by_bounces,
                  [&](auto twice) { see_sky<twice()>(world, batch, found); });
    if (plan.emission) see_emitters(world, batch, surfaces, found);
}

}  // namespace rt
