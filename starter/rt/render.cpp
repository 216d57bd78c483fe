#include "rt/render.h"

#include <sys/resource.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "rt/passes/pass.h"
#include "rt/passes/watch.h"

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

/// A pass that is not over in time may take so much longer, before it is given up.
constexpr Real grace = 1.05;

Real seconds_since(Clock::time_point start) { return std::chrono::duration<Real>(Clock::now() - start).count(); }

Real cpu_seconds() {
    rusage used;
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](timeval t) { return Real(t.tv_sec) + 1e-6 * Real(t.tv_usec); };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// The sum of all passes, each counted by its samples; and at the end a second one of the pixels that are rendered
/// twice.
struct Total {
    std::uint64_t samples = 0;
    std::vector<std::array<Sum, 3>> sums;  // channel by channel

    explicit Total(std::size_t colors) : sums(colors) {}

    void add(const Color* means, int count) {
        tbb::parallel_for(std::size_t(0), sums.size(), [&](std::size_t k) {
            for (int i = 0; i < 3; ++i) sums[k][std::size_t(i)].add(Real(count) * means[k][i]);
        });
        samples += std::uint64_t(count);
    }
    Color sum(std::size_t k) const { return {sums[k][0].value(), sums[k][1].value(), sums[k][2].value()}; }
    Color mean(std::size_t k) const { return sum(k) / Real(samples); }
};

/// Root mean square over pixels and channels of the error of one of two independent estimates: its variance is half of
/// that of their difference.
template <class First, class Second>
Real rmse(const std::vector<std::size_t>& control, First first, Second second) {
    Sum squares;
    for (std::size_t i = 0; i < control.size(); ++i) {
        const Color d = first(control[i]) - second(i);
        squares.add(dot(d, d) / 6);
    }
    return control.empty() ? std::numeric_limits<Real>::quiet_NaN() : std::sqrt(squares.value() / Real(control.size()));
}

/// One pass with all samples.
void render_at_once(const RenderSettings& settings, Passes& passes, Watch& watch, Clock::time_point start,
                    Rendering& r) {
    const auto finished = [&](std::size_t first, std::size_t last, Real share) {
        if (watch.paints()) watch.paint(first, last, [&](std::size_t k) { return passes.means()[k]; });
        watch.look(share, seconds_since(start) * (1 - share) / share);
    };
    const bool whole = passes.run(
        {settings.sampler, settings.seed, 0, settings.samples}, [&] { return settings.stop && settings.stop(); },
        finished);
    std::copy(passes.means(), passes.means() + passes.pixels(), r.image.pixels.begin());
    r.samples = std::uint64_t(settings.samples);
    r.done = whole ? 1 : Real(passes.done()) / Real(passes.pixels() + passes.control().size());
    if (whole)
        r.rmse = rmse(
            passes.control(), [&](std::size_t k) { return passes.means()[k]; },
            [&](std::size_t i) { return passes.again()[i]; });
}

/// Pass after pass until a limit. Of the first one, what is there in time is better than nothing; of a later one, half
/// would make the picture uneven.
void render_until(const RenderSettings& settings, Passes& passes, Watch& watch, Clock::time_point start, Rendering& r) {
    const Goals limits{settings.time_limit, settings.target_error};
    const std::size_t pixels = passes.pixels();
    Total total(pixels + passes.control().size());
    SoFar so_far;
    for (int pass = 0;; ++pass) {
        const int count = next_pass(limits, so_far);
        if (count == 0) break;
        const Slice slice = next_slice(settings.sampler, settings.seed, pass, total.samples, count);
        const auto stop = [&] {
            return (settings.stop && settings.stop()) || seconds_since(start) > grace * limits.time;
        };
        const auto finished = [&](std::size_t first, std::size_t last, Real) {
            if (watch.paints())
                watch.paint(first, last, [&](std::size_t k) {
                    return (total.sum(k) + Real(count) * passes.means()[k]) /
                           Real(total.samples + std::uint64_t(count));
                });
            const Real spent = seconds_since(start), of_error = sqr(limits.error / so_far.rmse),
                       share = std::min<Real>(1, std::max(spent / limits.time, of_error));
            watch.look(share, share > 0 ? spent * (1 - share) / share : inf);
        };
        const bool whole = passes.run(slice, stop, finished);
        if (!whole && pass > 0) break;
        total.add(passes.means(), count);
        if (!whole) r.done = Real(passes.done()) / Real(pixels + passes.control().size());
        if (!whole) break;

        const Real seconds = seconds_since(start);
        r.rmse = rmse(
            passes.control(), [&](std::size_t k) { return total.mean(k); },
            [&](std::size_t i) { return total.mean(pixels + i); });
        so_far = {total.samples, seconds, (seconds - so_far.seconds) / count, std::isnan(r.rmse) ? inf : r.rmse};
    }
    tbb::parallel_for(std::size_t(0), pixels, [&](std::size_t k) { r.image.pixels[k] = total.mean(k); });
    r.samples = total.samples;
}

}  // namespace

Rendering render(const Scene& scene, const RenderSettings& settings) {
    // More threads than cores only where they are asked for; and for all that follows, the tree as well.
    std::optional<tbb::global_control> most;
    if (settings.threads > 0) most.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(settings.threads));
    tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);

    const World world = arena.execute([&] { return make_world(scene, sampling_of(settings)); });
    const ivec2 size = scene.camera.size;
    const Crop crop = settings.crop.value_or(Crop{0, 0, size.x, size.y});
    const auto start = Clock::now();
    const Real cpu_start = cpu_seconds();

    Rendering result;
    result.image = Image(crop.width, crop.height);
    Passes passes(world, settings, crop);
    Watch watch(settings, crop.width, crop.height);
    arena.execute([&] {
        (sampling_of(settings).passes ? render_until : render_at_once)(settings, passes, watch, start, result);
    });
    result.stopped = settings.stop && settings.stop();
    result.rays = passes.rays;
    result.twice = passes.control().size();
    result.bad_sample = passes.bad_sample;
    result.wall_seconds = seconds_since(start);
    result.cpu_seconds = cpu_seconds() - cpu_start;
    return result;
}

}  // namespace rt
