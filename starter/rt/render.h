#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "rt/files/image.h"
#include "rt/plan.h"
#include "rt/ray.h"
#include "rt/scene.h"

namespace rt {

/// A rectangle of pixels: x, y of its top left corner, width, height.
struct Crop {
    int x = 0, y = 0, width = 0, height = 0;
};

struct RenderSettings {
    int samples = 16;
    std::uint64_t seed = 0;
    int threads = 0;  // 0: one for each core
    Sampler sampler = Sampler::orthogonal;
    bool one_of_many = false;   // pictures with other seeds are averaged with this one: one sample a pixel is random, too
    std::optional<Crop> crop;   // default: the whole film
    bool estimate_error = true; // renders some pixels twice
    Real time_limit = inf;      // [s]; passes of `samples` samples follow each other until then
    Real target_error = 0;      // RMSE; passes follow each other until it is reached. With neither limit: one pass
    std::function<void(Real done, Real seconds_left)> progress;  // done: share of the work, 0 to 1
    std::function<bool()> stop;  // asked by any thread now and then; true: end soon, and keep what is there
};

inline Sampling sampling_of(const RenderSettings& s) {
    return {s.samples, s.time_limit < inf || s.target_error > 0, s.sampler, s.one_of_many};
}

struct Rendering {
    Image image;           // of the crop
    std::uint64_t samples = 0;  // a pixel, in all passes
    RayCounts rays{};
    Real wall_seconds = 0, cpu_seconds = 0;  // of rendering alone
    Real rmse = 0;         // estimated from independent repetitions of some pixels, mean over channels; nan: unknown
    std::string fault;     // the first sample that was no finite number, with its pixel; empty: none
};

/// Renders a scene. The image depends on scene, samples, seed and sampler only: not on threads.
Rendering render(const Scene& scene, const RenderSettings& settings);

/// Every intermediate value of the paths through one pixel, as text.
std::string trace_pixel(const Scene& scene, const RenderSettings& settings, int x, int y);

}  // namespace rt
