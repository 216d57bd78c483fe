/// Workers on several threads share nothing but the world. The threads are the standard library's, not the scheduler's:
/// the thread sanitizer cannot see into a scheduler that was built without it, and takes all that it hands over for
/// races.
///
///     threads SCENE...    0: the pictures have the same bits as with one thread; 1: they have not

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <thread>

#include "rt/files/scene_reader.h"
#include "rt/path.h"

namespace {

constexpr int samples = 4;

/// Every so many pixels, from `first` on.
void draw(const rt::World& world, std::size_t first, std::size_t step, std::vector<rt::Color>& means) {
    rt::Worker worker(world);
    const std::size_t width = std::size_t(world.scene.camera.size.x);
    for (std::size_t k = first; k < means.size(); k += step) {
        const int x = int(k % width), y = int(k / width);
        const rt::Bits key = rt::pixel_key(1, int(width), x, y, rt::Sampler::sobol);
        worker.render({{x, y, key}}, samples, rt::Sampler::sobol, &means[k]);
    }
}

std::vector<rt::Color> picture(const rt::World& world, std::size_t threads) {
    const rt::ivec2 size = world.scene.camera.size;
    std::vector<rt::Color> means(std::size_t(size.x) * std::size_t(size.y));
    {
        std::vector<std::jthread> running;
        for (std::size_t t = 0; t < threads; ++t) running.emplace_back([&, t] { draw(world, t, threads, means); });
    }
    return means;
}

}  // namespace

int main(int count, char** words) {
    const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
    int apart = 0;
    for (int i = 1; i < count; ++i) {
        rt::Scene scene = rt::read_scene(words[i]);
        scene.camera.size = {48, 32};
        scene.samples = samples;
        const rt::World world = rt::make_world(scene);
        const bool same = picture(world, 4) == picture(world, 1);
        fmt::print("{}: {}\n", words[i], same ? "the same bits" : "FAILED: other bits");
        apart += !same;
    }
    return apart > 0;
}
