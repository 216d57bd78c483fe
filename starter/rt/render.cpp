#include "rt/render.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

#include "rt/path.h"

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

Real seconds_since(Clock::time_point start) { return std::chrono::duration<Real>(Clock::now() - start).count(); }

Real cpu_seconds() {
    rusage used;
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](timeval t) { return Real(t.tv_sec) + 1e-6 * Real(t.tv_usec); };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Which pixels of the crop are rendered twice to estimate the error: every so many, at least a few hundred in all.
int control_stride(std::size_t pixels) { return int(std::clamp<std::size_t>(pixels / 512, 1, 31)); }

/// One pass over the crop, with what it adds up.
struct Pass {
    const World& world;
    const RenderSettings& settings;
    Crop crop;
    std::mutex mutex;
    RayCounts rays{};
    std::string fault;
    std::atomic<std::size_t> done{0};
    std::atomic<bool> stopped{false};

    void run(std::uint64_t seed, const std::vector<std::size_t>& pixels, std::vector<Color>& means,
             const std::function<void(std::size_t)>& progress) {
        const int chunk = std::max(1, chunk_samples / settings.samples);
        const std::size_t chunks = (pixels.size() + std::size_t(chunk) - 1) / std::size_t(chunk);
        tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(world); });
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks), [&](const auto& range) {
            Worker& worker = workers.local();
            for (std::size_t c = range.begin(); c < range.end(); ++c) {
                if (settings.stop && settings.stop()) stopped = true;
                if (stopped) return;
                const std::size_t first = c * std::size_t(chunk),
                                  last = std::min(pixels.size(), first + std::size_t(chunk));
                std::vector<PixelWork> work;
                for (std::size_t k = first; k < last; ++k) {
                    const int x = crop.x + int(pixels[k] % std::size_t(crop.width)),
                              y = crop.y + int(pixels[k] / std::size_t(crop.width));
                    work.push_back({x, y, pixel_key(world.scene.camera, seed, x, y)});
                }
                worker.render(work, settings.samples, settings.sampler, &means[first]);
                const std::size_t so_far = done += last - first;
                if (!worker.fault.empty() || progress) {
                    const std::lock_guard lock(mutex);
                    if (fault.empty()) fault = worker.fault;
                    if (progress) progress(so_far);
                }
            }
        });
        for (const Worker& worker : workers)
            for (std::size_t k = 0; k < rays.size(); ++k) rays[k] += worker.chunk.rays[k];
    }
};

/// Mean over pixels and channels of half the squared difference of two independent estimates: the variance of one.
Real variance(const std::vector<Color>& a, const std::vector<Color>& b) {
    Sum squares;
    for (std::size_t i = 0; i < a.size(); ++i) squares.add(dot(a[i] - b[i], a[i] - b[i]) / 6);
    return squares.value() / Real(a.size());
}

}  // namespace

Rendering render(const Scene& scene, const RenderSettings& settings) {
    World world = make_world(scene, sampling_of(settings));
    const ivec2 size = scene.camera.size;
    const Crop crop = settings.crop.value_or(Crop{0, 0, size.x, size.y});
    const auto start = Clock::now();
    const Real cpu_start = cpu_seconds();

    std::vector<std::size_t> all(std::size_t(crop.width) * std::size_t(crop.height));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    std::vector<std::size_t> control;
    if (settings.estimate_error)
        for (std::size_t i = 0; i < all.size(); i += std::size_t(control_stride(all.size()))) control.push_back(i);

    Rendering result;
    result.image = Image(crop.width, crop.height);
    result.rmse = std::numeric_limits<Real>::quiet_NaN();
    const bool limited = settings.time_limit < inf || settings.target_error > 0;
    // More threads than cores only where they are asked for.
    std::optional<tbb::global_control> most;
    if (settings.threads > 0) most.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(settings.threads));
    tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
    Pass pass{world, settings, crop, {}, {}, {}, {}, {}};
    std::vector<Color> means(all.size()), first(control.size()), again(control.size());
    std::vector<Sum> sums(limited ? 3 * all.size() : 0);  // of the passes, channel by channel
    Real of_one_pass = 0;
    int passes = 0;
    const auto progress = [&](std::size_t done) {
        const Real spent = seconds_since(start);
        Real share = Real(done) / Real(all.size());
        if (settings.time_limit < inf) share = std::min<Real>(1, spent / settings.time_limit);
        if (settings.progress) settings.progress(share, share > 0 ? spent * (1 - share) / share : inf);
    };
    do {
        pass.done = 0;
        arena.execute([&] {
            pass.run(combine(settings.seed, Bits(passes)), all, means,
                     settings.progress ? progress : std::function<void(std::size_t)>{});
        });
        // Of the first pass, what is there is better than nothing; of a later one, half a pass would be uneven.
        if (pass.stopped && passes > 0) break;
        if (!limited) result.image.pixels = means;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i].add(means[i / 3][int(i % 3)]);
            result.image.pixels[i / 3][int(i % 3)] = sums[i].value() / Real(passes + 1);
        }
        if (passes == 0 && settings.estimate_error && !pass.stopped) {
            for (std::size_t i = 0; i < control.size(); ++i) first[i] = means[control[i]];
            arena.execute([&] { pass.run(combine(~settings.seed, 0), control, again, {}); });
            of_one_pass = variance(first, again);
        }
        ++passes;
        if (settings.estimate_error && !pass.stopped) result.rmse = std::sqrt(of_one_pass / passes);
    } while (limited && seconds_since(start) < settings.time_limit && !(result.rmse <= settings.target_error) &&
             !pass.stopped);

    result.samples = std::uint64_t(settings.samples) * std::uint64_t(passes);
    result.rays = pass.rays;
    result.fault = pass.fault;
    result.wall_seconds = seconds_since(start);
    result.cpu_seconds = cpu_seconds() - cpu_start;
    return result;
}

}  // namespace rt
