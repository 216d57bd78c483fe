#include "rt/stages/stages.h"

namespace rt {
namespace {

/// The numbers of the first rays.
struct CameraNumbers {
    Numbers film, lens, time;
};

/// in_cells  film_sample itself deals out the cells of the pixel
template <bool in_cells, bool lens, bool time>
void first_rays(const World& world, const CameraWork& work, const CameraNumbers& u, Batch& batch, Real* weights) {
    // Copies: the compiler keeps them in registers.
    const Camera camera = world.scene.camera;
    const Shutter shutter = world.scene.shutter;
    const int n = work.pattern.n;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Bits key = work.keys[i];
        const int index = work.samples[i];
        const FilmSample film = film_sample(work.extents[i], in_cells ? index : 0, in_cells ? n : 1, u.film.at(i));
        batch.set_ray(i, camera_ray(camera, film.position));
        if constexpr (lens)
            batch.set_ray(i, lens_ray(camera, batch.ray(i), u.lens.at(i)));
        batch.time[i] = 0;
        if constexpr (time)
            batch.time[i] = shutter_time(shutter, u.time.x[i]);
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

/// The cells of a stratified pixel are film_sample's own; other patterns are laid over the whole pixel.
void draw_film(const World& world, const CameraWork& work, Numbers& u) {
    Pattern pattern = work.pattern;
    if (pattern.sampler == Sampler::stratified) pattern.sampler = Sampler::random;
    if (pattern.sampler == Sampler::uniform)
        for (int i = 0; i < lanes; ++i) u.x[i] = u.y[i] = 0.5;
    else
        draw_2d(pattern, camera_dimension(world, pixel_dimension, pattern.n), work.keys, work.samples, lanes, u);
}

}  // namespace

void camera_stage(const World& world, const CameraWork& work, Batch& batch, Chunk& chunk) {
    Real* weights = chunk.weight.data() + work.slot;
    const auto [sampler, n] = work.pattern;
    CameraNumbers u;
    draw_film(world, work, u.film);
    if (world.plan.lens)
        draw_2d(work.pattern, camera_dimension(world, lens_dimension, n), work.keys, work.samples, lanes, u.lens);
    if (world.plan.time)
        draw_1d(work.pattern, camera_dimension(world, time_dimension, n), work.keys, work.samples, lanes, u.time);
    with_flag(sampler == Sampler::stratified || sampler == Sampler::uniform, [&](auto in_cells) {
        with_flag(world.plan.lens, [&](auto lens) {
            with_flag(world.plan.time, [&](auto time) {
                first_rays<in_cells(), lens(), time()>(world, work, u, batch, weights);
            });
        });
    });
    chunk.rays[int(RayKind::camera)] += std::uint64_t(work.count);
}

}  // namespace rt
