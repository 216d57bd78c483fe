#include "rt/stages/scatter.h"

#include "rt/stages/follow.h"

/// How paths go on from the surfaces that they meet. Fragments are called in scatter.h, for one ray; here are the loops
/// over all of a batch:
///
///     choose_...     which lanes go which way: where several lead on, one is chosen; mirror and glass, if there is
///                    nothing else, are both followed
///     scatter_stage  way after way; follow, in follow.cpp, sends the rays of all lanes that go one way
namespace rt {
namespace {

/// Decides how all lanes go on.
void choose_ways(const Wave& wave, AllLeaving& leaving) {
    Numbers u;
    bool drawn = false;
    leaving.clear();
    for (int i = 0; i < wave.batch.count; ++i) {
        if (wave.surfaces.material[i] == nothing) continue;
        const Shares shares = shares_of(wave, i);
        const Color weight = wave.batch.weight.at(i);
        const Real sum = shares.sum();
        if (sum == 0) continue;
        if (wave.world.plan.split) {
            if (shares.mirror > 0) leaving[WayOn::mirror].add(i, weight * shares.weights.mirror);
            if (shares.glass > 0) leaving[WayOn::glass].add(i, weight * shares.weights.glass);
            continue;
        }
        const bool alone = shares.is_one();
        if (!alone && !drawn) wave.draw_1d(choice_dimension, wave.batch.count, u), drawn = true;
        const Shares::Way way = shares.chosen(alone ? 0 : u.x[i]);
        leaving[way.way].add(i, weight * way.weight * (sum / way.share));
    }
}

/// Every lane with an albedo bounces, if bounces are the only way on.
void choose_bounces(const Wave& wave, Leaving& leaving) {
    const World& world = wave.world;
    const Batch& b = wave.batch;
    const Surfaces& s = wave.surfaces;
    const Material* materials = world.scene.materials.data();
    leaving.count = 0;
    for (int i = 0; i < b.count; ++i) {
        const bool on = s.material[i] != nothing && b.bounce[i] < world.scene.bounces &&
                        materials[s.material[i]].albedo != Color(0);
        leaving.lane[leaving.count] = i;
        leaving.weight.set(leaving.count, b.weight.at(i));
        leaving.count += on;
    }
}

}  // namespace

void scatter_stage(const Wave& wave, Queue& next, Chunk& chunk) {
    const RenderPlan& plan = wave.world.plan;
    if (!plan.specular && !plan.lobe && !plan.bounce) return;
    AllLeaving leaving;
    if (plan.split) {
        choose_ways(wave, leaving);
        follow_both(wave, leaving, next, chunk);
    } else if (!plan.specular && !plan.lobe) {
        choose_bounces(wave, leaving[WayOn::bounce]);
        follow<WayOn::bounce>(wave, leaving, next, chunk);
    } else {
        choose_ways(wave, leaving);
        follow<WayOn::mirror>(wave, leaving, next, chunk);
        follow<WayOn::glossy>(wave, leaving, next, chunk);
        follow<WayOn::glass>(wave, leaving, next, chunk);
        follow<WayOn::translucent>(wave, leaving, next, chunk);
        follow<WayOn::bounce>(wave, leaving, next, chunk);
    }
}

}  // namespace rt
