#pragma once

#include <vector>

#include "rt/passes/schedule.h"
#include "rt/stages/stages.h"

namespace rt {

/// How many samples a worker takes on at once, so that later waves still fill their batches.
constexpr int chunk_samples = 1024;

struct PixelWork {
    int x, y;  // of the film [pixel]
    Bits key;  // of its random numbers
};

struct Trace;

/// What one thread needs to follow paths: the stages' batches, kept from chunk to chunk.
struct Worker {
    const World& world;
    Chunk chunk;
    std::optional<BadSample> bad_sample;  // the first there was
    Trace* trace = nullptr;               // where the fragments' answers are told; none: not told

    explicit Worker(const World& world) : world(world) {}

    /// The means of some pixels with n samples each, from the sample of index `from` on.
    void render(const std::vector<PixelWork>& pixels, int n, Sampler sampler, Color* means, int from = 0);

private:
    Queue now, next;
    Batch first, shadow;
    Surfaces surfaces;
    std::vector<LaneDigits> digits;  // of the pattern of `digits_for` samples
    int digits_for = 0;
    Colors found;  // what each lane of a batch adds to its sample

    Pattern pattern_for(Sampler sampler, int n);
    void first_wave(const std::vector<PixelWork>& pixels, Pattern pattern, int from);
    void follow(Batch& batch, Pattern pattern, int number);
    void add_found(const Batch& batch, bool in_order);
};

}  // namespace rt
