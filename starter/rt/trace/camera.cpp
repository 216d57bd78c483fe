#include "rt/fragments.h"
#include "rt/trace/words.h"

namespace rt {

void trace_camera(const World& world, const CameraWork& work, const Batch& batch, Trace& trace) {
    const RenderPlan& plan = world.plan;
    const Sampler sampler = work.pattern.sampler;
    const int n = work.pattern.n;
    const bool in_cells = sampler == Sampler::stratified || sampler == Sampler::uniform;
    Pattern film = work.pattern;
    if (sampler == Sampler::stratified) film.sampler = Sampler::random;
    Numbers u, lens, time;
    if (plan.pixel) draw_2d(film, camera_dimension(world, pixel_dimension, n), work.keys, work.samples, work.count, u);
    if (plan.lens)
        draw_2d(work.pattern, camera_dimension(world, lens_dimension, n), work.keys, work.samples, work.count, lens);
    if (plan.time)
        draw_1d(work.pattern, camera_dimension(world, time_dimension, n), work.keys, work.samples, work.count, time);
    for (int i = 0; i < work.count; ++i) {
        Told& told = trace.of(batch, i);
        told.text += fmt::format("sample {}\n", batch.sample[i]);
        const Extent pixel = work.pixel(i);
        FilmSample on_film{0.5 * (pixel.low + pixel.high), 1};
        if (plan.pixel) {
            const vec2 numbers = sampler == Sampler::uniform ? vec2(0.5) : u.at(i);
            on_film = film_sample(pixel, in_cells ? work.samples[i] : 0, in_cells ? n : 1, numbers);
            tell(told, "film_sample", "u {}: position {}, weight {}", text(numbers), text(on_film.position),
                 text(on_film.weight));
        }
        const Ray pinhole = camera_ray(world.scene.camera, on_film.position);
        tell(told, "camera_ray", "from {} along {}", text(pinhole.origin), text(pinhole.direction));
        if (plan.lens) {
            const Ray ray = lens_ray(world.scene.camera, pinhole, lens.at(i));
            tell(told, "lens_ray", "u {}: from {} along {}", text(lens.at(i)), text(ray.origin), text(ray.direction));
        }
        if (plan.time) tell(told, "shutter_time", "u {}: {} s", text(time.x[i]), text(batch.time[i]));
    }
}

}  // namespace rt
