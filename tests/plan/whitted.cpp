/// Draws a Whitted scene, made here, with the stages alone: no threads, no files. Prints a hash of the picture.

#include <cstdio>

#include "rt/path.h"
#include "rt/trace.h"

// No trace is asked for.
namespace rt {
void trace_camera(const World&, const CameraWork&, const Batch&, Trace&) {}
void trace_wave(const Wave&, Trace&) {}
void trace_ways(const Wave&, Trace&) {}
}  // namespace rt

namespace {

using namespace rt;

Scene whitted_scene() {
    Scene scene;
    Material floor, mirror, glass, shiny;
    floor.albedo = Color(0.6, 0.5, 0.4);
    mirror.reflectance = Color(0.9);
    glass.reflectance = glass.transmittance = Color(1);
    glass.ior = 1.5;
    shiny.albedo = Color(0.5, 0.1, 0.1);
    shiny.specular = Color(0.4);
    shiny.shininess = 50;
    scene.materials = {floor, mirror, glass, shiny};
    scene.shapes = {{Quad{vec3(0), vec3(8, 0, 0), vec3(0, 0, -8)}, 0, vec3(0)},
                    {Sphere{vec3(-1.2, 1, -1), 1}, 1, vec3(0)},
                    {Sphere{vec3(1.2, 1, 0.5), 1}, 2, vec3(0)},
                    {Sphere{vec3(0.2, 0.5, 1.8), 0.5}, 3, vec3(0)}};
    scene.lights = {{vec3(3, 6, 3), Color(60), false}};
    scene.camera.eye = vec3(0, 1.5, 6);
    scene.camera.size = ivec2(64, 64);
    scene.samples = 1;
    scene.depth = 8;
    return scene;
}

}  // namespace

/// What is counted: all pixels, as many at a time as the renderer takes.
extern "C" __attribute__((noinline)) Bits measured(Worker& worker, const Camera& camera, int samples) {
    Bits hash = 0;
    std::vector<PixelWork> pixels;
    std::vector<Color> means(chunk_samples);
    for (int y = 0; y < camera.size.y; ++y) {
        for (int x = 0; x < camera.size.x; ++x) {
            pixels.push_back({x, y, pixel_key(1, camera.size.x, x, y, Sampler::sobol)});
            if (int(pixels.size()) < chunk_samples / samples) continue;
            worker.render(pixels, samples, Sampler::sobol, means.data());
            for (std::size_t i = 0; i < pixels.size(); ++i)
                for (int k = 0; k < 3; ++k) hash = combine(hash, std::bit_cast<Bits>(means[i][k]));
            pixels.clear();
        }
    }
    return hash;
}

int main() {
    const World world = make_world(whitted_scene());
    Worker worker(world);
    std::printf("%016llx", static_cast<unsigned long long>(measured(worker, world.scene.camera, world.scene.samples)));
    for (const auto count : worker.chunk.rays) std::printf(" %llu", static_cast<unsigned long long>(count));
    std::printf("\n");
}
