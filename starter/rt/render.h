#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "rt/files/image.h"
#include "rt/passes/schedule.h"
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
    bool one_of_many = false;  // others with other seeds are averaged with this one: one sample a pixel is random, too
    std::optional<Crop> crop;  // default: the whole film
    bool estimate_error = true;  // renders some pixels twice
    // With a limit, passes follow each other until it is reached, and `samples` does not count; else one pass.
    Real time_limit = inf;  // of rendering, with the estimate of the error [s]
    Real target_error = 0;  // RMSE
    // Asked and told now and then, by any thread, but never by two at once:
    std::function<void(Real done, Real seconds_left)> progress;  // done: share of the work, 0 to 1
    std::function<void(const Image&)> show;                      // the picture of the crop; black where nothing is yet
    // Asked by any thread; true: end soon, and keep what is there.
    std::function<bool()> stop;
};

inline Sampling sampling_of(const RenderSettings& s) {
    return {s.samples, s.time_limit < inf || s.target_error > 0, s.sampler, s.one_of_many};
}

struct Rendering {
    Image image;                // of the crop
    std::uint64_t samples = 0;  // a pixel, in all passes
    Real done = 1;              // share of the pixels that are there; the others are black
    bool stopped = false;       // RenderSettings::stop has ended it
    RayCounts rays{};
    Real wall_seconds = 0, cpu_seconds = 0;              // of rendering alone
    Real rmse = std::numeric_limits<Real>::quiet_NaN();  // estimated from pixels that are rendered twice; nan: unknown
    std::size_t twice = 0;                               // so many of them
    std::optional<BadSample> bad_sample;                 // the first there was
};

/// Renders a scene. Without limits, the image depends on scene, samples, seed and sampler only: not on threads.
Rendering render(const Scene& scene, const RenderSettings& settings);

/// Every intermediate value of the paths through one pixel, as text.
std::string trace_pixel(const Scene& scene, const RenderSettings& settings, int x, int y);

}  // namespace rt
