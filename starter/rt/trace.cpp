#include "rt/trace.h"

#include <fmt/format.h>

#include "rt/path.h"
#include "rt/render.h"

namespace rt {
namespace {

std::string text(vec3 v) { return fmt::format("({:.17g}, {:.17g}, {:.17g})", v.x, v.y, v.z); }

constexpr const char* event_names[] = {"camera", "diffuse", "specular", "lobe", "medium"};

}  // namespace

std::string describe_wave(const World& world, int wave, const Batch& b, const Surfaces& s) {
    std::string out;
    for (int i = 0; i < b.count; ++i) {
        out += fmt::format("sample {}, wave {}, from {}\n", b.sample[i], wave, event_names[b.event[i]]);
        out += fmt::format("  origin     {}\n  direction  {}\n", text({b.ox[i], b.oy[i], b.oz[i]}),
                           text({b.dx[i], b.dy[i], b.dz[i]}));
        out += fmt::format("  weight     {}\n", text(b.weight(i)));
        if (world.plan.time) out += fmt::format("  time       {:.17g} s\n", b.time[i]);
        if (b.medium[i] != nothing)
            out += fmt::format("  inside     {}\n", world.scene.materials[std::size_t(b.medium[i])].name);
        if (b.shape[i] == ended) {
            out += "  scattered before it meets a surface\n";
        } else if (s.material[i] == nothing) {
            out += "  meets nothing\n";
        } else {
            out += fmt::format("  meets      shape {} of material {}, from {}, at distance {:.17g}\n", b.shape[i],
                               world.scene.materials[std::size_t(s.material[i])].name,
                               s.behind[i] ? "behind" : "the front", b.far[i]);
            out += fmt::format("  point      {}, off by less than {:.3g}\n  normal     {}\n", text(s.hit(i).point),
                               s.error[i], text(s.normal(i)));
        }
    }
    return out;
}

std::string describe_light(const Batch& b, const Chunk& chunk) {
    std::string out;
    for (int i = 0; i < b.count; ++i)
        out += fmt::format("sample {} has gathered {}\n", b.sample[i], text(chunk.radiance[std::size_t(b.slot[i])]));
    return out;
}

std::string trace_pixel(const Scene& scene, const RenderSettings& settings, int x, int y) {
    const World world = make_world(scene, sampling_of(settings));
    std::string out;
    Worker worker(world);
    worker.trace = &out;
    Color mean;
    const Bits key = pixel_key(scene.camera, combine(settings.seed, 0), x, y);
    worker.render({{x, y, key}}, settings.samples, settings.sampler, &mean);
    return out + fmt::format("pixel {},{}: mean {}\n", x, y, text(mean));
}

}  // namespace rt
