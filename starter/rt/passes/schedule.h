#pragma once

#include <cstdint>
#include <optional>

#include "rt/math.h"
#include "rt/sampler.h"

/// Passes over a picture until a limit is reached: how many samples a pixel each takes, and which. Nobody needs this
/// file for the assignment.
namespace rt {

/// The samples of each pixel that one pass adds.
struct Slice {
    Sampler sampler;
    Bits seed;  // a picture of this seed, of this sampler and of first + count samples holds them
    int first;  // index of the first
    int count;
};

/// A sample that is no finite number.
struct BadSample {
    ivec2 pixel;                // [pixel]
    std::optional<int> sample;  // its index; none: each sample is finite, but their mean is not
    Color radiance;             // of the sample, or of the mean
    Slice slice;                // the samples it is one of
};

struct Goals {
    Real time = inf;  // [s]
    Real error = 0;   // RMSE
};

/// What is known after some passes.
struct SoFar {
    std::uint64_t samples = 0;  // a pixel
    Real seconds = 0;           // since the start
    Real per_sample = 0;  // what one sample of every pixel took in the last pass, with the estimate of the error [s]
    Real rmse = inf;
};

/// How many samples a pixel the next pass takes; 0: enough.
///
/// The first pass takes one. Each further one doubles the samples, but it takes at most a twelfth of the time limit,
/// and at the end a half or a quarter of that if it has to fit; nor more than the error still asks for, which falls at
/// least as 1/sqrt(samples). Powers of two: a piece of a Sobol' sequence of that length is as even as the whole.
int next_pass(const Goals& limits, const SoFar& so_far);

/// Pass number `pass` of a picture, after so many samples.
///
/// Independent numbers and Sobol' sequences go on where the last pass ended: many passes are as even as one. An
/// orthogonal array must know its number of samples in advance: Sobol' stands in. So must cells: each pass has its own.
Slice next_slice(Sampler sampler, Bits seed, int pass, std::uint64_t samples, int count);

}  // namespace rt
