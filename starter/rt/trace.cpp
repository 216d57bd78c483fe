#include "rt/trace.h"

#include "rt/path.h"
#include "rt/trace/words.h"

namespace rt {

PixelTrace trace_paths(const Scene& scene, const RenderSettings& settings, int x, int y) {
    const World world = make_world(scene, sampling_of(settings));
    PixelTrace traced;
    traced.trace.samples.resize(std::size_t(settings.samples));
    Worker worker(world);
    worker.trace = &traced.trace;
    const Bits key = pixel_key(combine(settings.seed, 0), scene.camera.size.x, x, y, settings.sampler);
    worker.render({{x, y, key}}, settings.samples, settings.sampler, &traced.mean);
    traced.radiance = worker.chunk.radiance;
    for (std::size_t k = 0; k < traced.radiance.size(); ++k)
        tell(traced.trace.samples[k], "gathered", "{}", text(traced.radiance[k]));
    return traced;
}

std::string trace_pixel(const Scene& scene, const RenderSettings& settings, int x, int y) {
    const PixelTrace traced = trace_paths(scene, settings, x, y);
    std::string out =
        fmt::format("pixel {},{}: {} {}\n", x, y, settings.samples, settings.samples == 1 ? "sample" : "samples");
    for (const Told& told : traced.trace.samples) out += told.text;
    return out + fmt::format("{:<22}{}\n", settings.samples > 1 ? "pixel_mean" : "pixel", text(traced.mean));
}

}  // namespace rt
