#include "rt/stages/stages.h"

namespace rt {

void emission_stage(const World& world, const Batch& b, const Surfaces& s, Chunk& chunk) {
    const bool sky = world.plan.environment || world.scene.background != Color(0);
    if (!sky && !world.plan.emission) return;
    for (int i = 0; i < b.count; ++i) {
        const Event from = Event(b.event[i]);
        Color light(0);
        if (b.shape[i] == nothing) {
            if (world.plan.environment && emission_counts(from, world.plan.environment_lit))
                light = world.scene.environment;
            if (from == Event::camera) light += world.scene.background;
        } else if (s.material[i] != nothing && !s.behind[i]) {
            const Color emission = world.scene.materials[std::size_t(s.material[i])].emission;
            if (emission == Color(0) || !emission_counts(from, world.surfaces[std::size_t(b.shape[i])].sampled))
                continue;
            light = emission;
        }
        chunk.radiance[std::size_t(b.slot[i])] += b.weight(i) * light;
    }
}

}  // namespace rt
