#include "rt/passes/pass.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace rt {
namespace {

/// Which pixels are rendered twice: every so many, at least a few hundred in all.
std::size_t control_stride(std::size_t pixels) { return std::clamp<std::size_t>(pixels / 512, 1, 31); }

}  // namespace

Passes::Passes(const World& world, const RenderSettings& settings, Crop crop)
    : world_(world), crop_(crop), pixels_(std::size_t(crop.width) * std::size_t(crop.height)) {
    if (settings.estimate_error)
        for (std::size_t k = 0; k < pixels_; k += control_stride(pixels_)) control_.push_back(k);
    means_.resize(pixels_ + control_.size());
}

PixelWork Passes::work(std::size_t item, const Slice& slice) const {
    const bool again = item >= pixels_;
    const std::size_t pixel = again ? control_[item - pixels_] : item, width = std::size_t(crop_.width);
    const int x = crop_.x + int(pixel % width), y = crop_.y + int(pixel / width);
    const Bits seed = combine(again ? ~slice.seed : slice.seed, 0);
    return {x, y, pixel_key(seed, world_.scene.camera.size.x, x, y, slice.sampler)};
}

bool Passes::run(const Slice& slice, const std::function<bool()>& stop, const Finished& finished) {
    const std::size_t chunk = std::size_t(std::max(1, chunk_samples / slice.count)), items = means_.size();
    tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(world_); });
    std::atomic<bool> stopped = false;
    std::atomic<std::size_t> done = 0;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, (items + chunk - 1) / chunk), [&](const auto& range) {
        Worker& worker = workers.local();
        for (std::size_t c = range.begin(); c < range.end(); ++c) {
            if (done > 0 && stop()) stopped = true;
            if (stopped) return;
            const std::size_t first = c * chunk, last = std::min(items, first + chunk);
            std::vector<PixelWork> pixels;
            for (std::size_t item = first; item < last; ++item) pixels.push_back(work(item, slice));
            worker.render(pixels, slice.count, slice.sampler, &means_[first], slice.first);
            const std::size_t so_far = done += last - first;
            if (finished) finished(std::min(first, pixels_), std::min(last, pixels_), Real(so_far) / Real(items));
        }
    });
    for (const Worker& worker : workers) {
        for (std::size_t k = 0; k < rays.size(); ++k) rays[k] += worker.chunk.rays[k];
        if (!bad_sample && worker.bad_sample) bad_sample = worker.bad_sample, bad_sample->slice = slice;
    }
    done_ = done;
    return !stopped;
}

}  // namespace rt
