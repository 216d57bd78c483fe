#include "rt/stages/stages.h"

namespace rt {
namespace {

template <Sampler sampler, bool lens, bool time>
void first_rays(const World& world, const CameraWork& work, Batch& batch, Real* weights) {
    // Copies: the compiler keeps them in registers.
    const Camera camera = world.scene.camera;
    const Shutter shutter = world.scene.shutter;
    const Dimension on_film = camera_dimension(world, pixel_dimension, work.n),
                    on_lens = camera_dimension(world, lens_dimension, work.n),
                    in_time = camera_dimension(world, time_dimension, work.n);
    constexpr bool in_cells = sampler == Sampler::stratified || sampler == Sampler::uniform;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Bits key = work.keys[i];
        const int index = work.samples[i];
        // The cells of a stratified pixel are film_sample's own; other patterns are laid over the whole pixel.
        const vec2 u = sampler == Sampler::stratified ? random_2d(key, Bits(index), pixel_dimension)
                       : sampler == Sampler::uniform  ? vec2(0.5)
                                                      : pattern_2d<sampler>(key, index, work.n, on_film);
        const FilmSample film = film_sample(work.extents[i], in_cells ? index : 0, in_cells ? work.n : 1, u);
        batch.set_ray(i, camera_ray(camera, film.position));
        if constexpr (lens)
            batch.set_ray(i, lens_ray(camera, batch.ray(i), pattern_2d<sampler>(key, index, work.n, on_lens)));
        batch.time[i] = 0;
        if constexpr (time)
            batch.time[i] = shutter_time(shutter, pattern_1d<sampler>(key, index, work.n, in_time));
        batch.set_weight(i, Color(1));
        batch.key[i] = key;
        batch.sample[i] = index;
        batch.slot[i] = work.slot + i;
        batch.event[i] = Index(Event::camera);
        batch.depth[i] = batch.bounce[i] = 0;
        batch.medium[i] = nothing;
        batch.near[i] = i < work.count ? batch.near[i] : inf;
        if (i < work.count) weights[i] = film.weight;
    }
}

}  // namespace

void camera_stage(const World& world, const CameraWork& work, Batch& batch, Chunk& chunk) {
    Real* weights = chunk.weight.data() + work.slot;
    with_sampler(work.sampler, [&](auto sampler) {
        with_flag(world.plan.lens, [&](auto lens) {
            with_flag(world.plan.time, [&](auto time) {
                first_rays<sampler(), lens(), time()>(world, work, batch, weights);
            });
        });
    });
    chunk.rays[int(RayKind::camera)] += std::uint64_t(work.count);
}

}  // namespace rt
