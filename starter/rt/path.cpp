#include "rt/path.h"

#include <fmt/format.h>

#include <algorithm>

#include "rt/trace.h"

namespace rt {
namespace {

/// No path is longer: light that is caught between mirrors or in a white medium for ever is given up.
constexpr int longest_path = 1 << 20;

}  // namespace

void Worker::first_wave(const std::vector<PixelWork>& pixels, int n, Sampler sampler) {
    Extent extents[lanes];
    Bits keys[lanes]{};
    int samples[lanes]{};
    const int all = int(pixels.size()) * n;
    now.clear();
    for (int slot = 0; slot < all; slot += lanes) {
        const int count = std::min(lanes, all - slot);
        for (int i = 0; i < count; ++i) {
            const PixelWork& pixel = pixels[std::size_t((slot + i) / n)];
            extents[i] = {vec2(pixel.x, pixel.y), vec2(pixel.x + 1, pixel.y + 1)};
            keys[i] = pixel.key;
            samples[i] = (slot + i) % n;
        }
        now.push();
        camera_stage(world, {extents, keys, samples, slot, count, n, sampler}, now.batches[now.used - 1], chunk);
        now.batches[now.used - 1].count = lanes;  // the next push opens a batch of its own
    }
    if (now.used > 0) now.batches[now.used - 1].count = all - (int(now.used) - 1) * lanes;
}

void Worker::follow(Batch& batch, int n, int wave, Sampler sampler) {
    nearest_stage(world, batch);
    medium_stage(world, sampler, n, wave, batch, next, chunk);
    surface_stage(world, batch, surfaces);
    if (trace) *trace += describe_wave(world, wave, batch, surfaces);
    emission_stage(world, batch, surfaces, chunk);
    direct_stage(world, sampler, n, wave, batch, surfaces, shadow, chunk);
    if (trace) *trace += describe_light(batch, chunk);
    scatter_stage(world, sampler, n, wave, batch, surfaces, next, chunk);
}

void Worker::render(const std::vector<PixelWork>& pixels, int n, Sampler sampler, Color* means) {
    const std::size_t all = pixels.size() * std::size_t(n);
    chunk.radiance.assign(all, Color(0));
    chunk.weight.resize(all);
    first_wave(pixels, n, sampler);
    for (int wave = 0; now.used > 0 && wave < longest_path; ++wave) {
        next.clear();
        for (std::size_t k = 0; k < now.used; ++k) follow(now.batches[k], n, wave, sampler);
        std::swap(now, next);
    }
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        means[k] = film_stage(&chunk.radiance[k * std::size_t(n)], &chunk.weight[k * std::size_t(n)], n);
        if (fault.empty() && !std::isfinite(means[k].x + means[k].y + means[k].z)) find_fault(pixels, n);
    }
}

void Worker::find_fault(const std::vector<PixelWork>& pixels, int n) {
    for (std::size_t slot = 0; slot < chunk.radiance.size(); ++slot) {
        const Color c = chunk.radiance[slot];
        if (std::isfinite(c.x + c.y + c.z)) continue;
        const PixelWork& pixel = pixels[slot / std::size_t(n)];
        fault = fmt::format("pixel {},{}, sample {}: radiance {} {} {}", pixel.x, pixel.y, slot % std::size_t(n), c.x,
                            c.y, c.z);
        return;
    }
    fault = fmt::format("pixel {},{}: the mean is no finite number, though every sample is", pixels[0].x, pixels[0].y);
}

}  // namespace rt
