#include "rt/path.h"

#include <algorithm>
#include <numeric>

#include "rt/trace.h"

namespace rt {
namespace {

/// No path is longer: light that is caught between mirrors or in a white medium for ever is given up.
constexpr int longest_path = 1 << 20;

bool is_finite(Color c) { return std::isfinite(c.x + c.y + c.z); }

}  // namespace

Pattern Worker::pattern_for(Sampler sampler, int n) {
    sampler = pattern_of(sampler, n);
    if (sampler != Sampler::orthogonal) return {sampler, n};
    if (n != digits_for) digits = digits_of_lanes(n), digits_for = n;
    return {sampler, n, digits.data()};
}

void Worker::first_wave(const std::vector<PixelWork>& pixels, Pattern pattern, int from) {
    const int n = pattern.n;
    Real x[lanes]{}, y[lanes]{};
    Bits keys[lanes]{};
    int samples[lanes]{};
    const int all = int(pixels.size()) * n;
    int pixel = 0, sample = 0;
    begin_camera(world, first);
    for (int slot = 0; slot < all; slot += lanes) {
        const int count = std::min(lanes, all - slot);
        for (int i = 0; i < count;) {
            const PixelWork& of = pixels[std::size_t(pixel)];
            const int here = std::min(count - i, n - sample);
            std::fill_n(x + i, here, of.x), std::fill_n(y + i, here, of.y), std::fill_n(keys + i, here, of.key);
            std::iota(samples + i, samples + i + here, from + sample);
            i += here, sample += here;
            if (sample == n) sample = 0, ++pixel;
        }
        const CameraWork work{x, y, keys, samples, slot, count, pattern};
        camera_stage(world, work, first, chunk);
        first.count = count;
        if (trace) trace_camera(world, work, first, *trace);
        follow(first, pattern, 0);
    }
}

/// in_order  whether the batch has consecutive samples to which nothing is added yet
void Worker::add_found(const Batch& batch, bool in_order) {
    if (in_order) {
        Color* const to = &chunk.radiance[std::size_t(batch.slot[0])];
        for (int i = 0; i < batch.count; ++i) to[i] = found.at(i);
    } else {
        for (int i = 0; i < batch.count; ++i) chunk.radiance[std::size_t(batch.slot[i])] += found.at(i);
    }
}

void Worker::follow(Batch& batch, Pattern pattern, int number) {
    const Wave wave{world, pattern, number, batch, surfaces};
    nearest_stage(world, batch);
    found = Colors{};
    medium_stage(wave, batch, shadow, next, found, chunk);
    surface_stage(world, batch, surfaces);
    emission_stage(world, batch, surfaces, found);
    direct_stage(wave, shadow, found, chunk);
    add_found(batch, number == 0);
    if (trace) trace_wave(wave, *trace);
    scatter_stage(wave, next, chunk);
    if (trace) trace_ways(wave, *trace);
}

void Worker::render(const std::vector<PixelWork>& pixels, int n, Sampler sampler, Color* means, int from) {
    const Pattern pattern = pattern_for(sampler, n);
    const std::size_t all = pixels.size() * std::size_t(n);
    chunk.radiance.resize(all);
    chunk.weight.resize(all);
    next.clear();
    first_wave(pixels, pattern, from);
    for (int wave = 1; next.used > 0 && wave < longest_path; ++wave) {
        std::swap(now, next);
        next.clear();
        for (std::size_t k = 0; k < now.used; ++k) follow(now.batches[k], pattern, wave);
    }
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        means[k] = film_stage(world, &chunk.radiance[k * std::size_t(n)], &chunk.weight[k * std::size_t(n)], n);
        if (bad_sample || is_finite(means[k])) continue;
        bad_sample = BadSample{{pixels[k].x, pixels[k].y}, {}, means[k], {sampler, 0, from, n}};
        const Color* const samples = &chunk.radiance[k * std::size_t(n)];
        const Color* const bad = std::find_if_not(samples, samples + n, is_finite);
        if (bad != samples + n) bad_sample->sample = from + int(bad - samples), bad_sample->radiance = *bad;
    }
}

}  // namespace rt
