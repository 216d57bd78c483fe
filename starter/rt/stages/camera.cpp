#include "rt/fragments.h"
#include "rt/stages/stages.h"

namespace rt {
namespace {

/// The numbers of the first rays.
struct CameraNumbers {
    Numbers film, lens, time;
};

/// Where a pixel's samples fall: in its centre, if there is one; in cells, which film_sample itself deals out; or where
/// the pattern, which is laid over the whole pixel, says.
enum class Film { centre, cells, pattern };

template <Film where, bool lens, bool time>
void first_rays(const World& world, const CameraWork& work, const CameraNumbers& u, Batch& batch, Real* weights) {
    const Camera camera = world.scene.camera;
    const Shutter shutter = world.scene.shutter;
    const int n = work.pattern.n;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Bits key = work.keys[i];
        const int index = work.samples[i];
        const Extent pixel = work.pixel(i);
        FilmSample film{0.5 * (pixel.low + pixel.high), 1};
        if constexpr (where == Film::cells) film = film_sample(pixel, index, n, u.film.at(i));
        if constexpr (where == Film::pattern) film = film_sample(pixel, 0, 1, u.film.at(i));
        batch.set_ray(i, camera_ray(camera, film.position));
        if constexpr (lens) batch.set_ray(i, lens_ray(camera, batch.ray(i), u.lens.at(i)));
        if constexpr (time) batch.time[i] = shutter_time(shutter, u.time.x[i]);
        batch.key[i] = key;
        batch.sample[i] = index;
        batch.slot[i] = work.slot + i;
        batch.near[i] = i < work.count ? batch.near[i] : inf;
        if (i < work.count) weights[i] = film.weight;
    }
}

/// Where rays start that begin near the boundary of a medium.
void find_starts(const World& world, int count, Batch& batch) {
    for (int i = 0; i < count; ++i) {
        Ray ray = batch.ray(i);
        batch.inside[i] = start_of(world, ray, batch.time[i]);
        batch.near[i] = ray.near;
    }
}

void draw_film(const World& world, const CameraWork& work, Numbers& u) {
    Pattern pattern = work.pattern;
    if (pattern.sampler == Sampler::stratified) pattern.sampler = Sampler::random;
    if (pattern.sampler == Sampler::uniform)
        for (int i = 0; i < lanes; ++i) u.x[i] = u.y[i] = 0.5;
    else
        draw_2d(pattern, camera_dimension(world, pixel_dimension, pattern.n), work.keys, work.samples, lanes, u);
}

}  // namespace

void begin_camera(const World& world, Batch& batch) {
    for (int i = 0; i < lanes; ++i) {
        batch.time[i] = 0;
        batch.weight.set(i, Color(1));
        batch.event[i] = Index(Event::camera);
        batch.depth[i] = batch.bounce[i] = 0;
        batch.inside[i] = world.regions.start;
    }
}

void camera_stage(const World& world, const CameraWork& work, Batch& batch, Chunk& chunk) {
    Real* weights = chunk.weight.data() + work.slot;
    const Sampler sampler = work.pattern.sampler;
    const int n = work.pattern.n;
    CameraNumbers u;
    if (world.plan.pixel) draw_film(world, work, u.film);
    if (world.plan.lens)
        draw_2d(work.pattern, camera_dimension(world, lens_dimension, n), work.keys, work.samples, lanes, u.lens);
    if (world.plan.time)
        draw_1d(work.pattern, camera_dimension(world, time_dimension, n), work.keys, work.samples, lanes, u.time);
    const auto send = [&](auto where) {
        with_flag(world.plan.lens, [&](auto lens) {
            with_flag(world.plan.time,
                      [&](auto time) { first_rays<where(), lens(), time()>(world, work, u, batch, weights); });
        });
    };
    if (!world.plan.pixel)
        send(std::integral_constant<Film, Film::centre>{});
    else if (sampler == Sampler::stratified || sampler == Sampler::uniform)
        send(std::integral_constant<Film, Film::cells>{});
    else
        send(std::integral_constant<Film, Film::pattern>{});
    if (!world.regions.asked.empty()) find_starts(world, work.count, batch);
    chunk.rays[int(RayKind::camera)] += std::uint64_t(work.count);
}

}  // namespace rt
