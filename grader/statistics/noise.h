#pragma once

#include <span>

#include "rt/image.h"
#include "statistics/region.h"

namespace grade {

/// Statistics of noise over images of one scene under different seeds; two at least, and better 32.

/// Design effect of a flat region of P pixels:
///
///     P Var(mean of the region) / mean Var(pixel)
///
/// 1 for independent pixels; P when all share their random numbers, the row length when the pixels of a row do. nan
/// without noise.
///
/// Source: Kish, "Survey Sampling", 1965.
double design_effect(std::span<const rt::Image> images, const Region& region);

/// Dispersion of pixels that see an emitter of brightness 1 or nothing, with N samples each:
///
///     mean of N Var(pixel) / (p (1 - p)),  p the pixel's mean over the images
///
/// over the pixels with 0 < p < 1. 1 for independent samples; 0.40, 0.20, 0.10, 0.05 for jittered ones on an edge, at
/// N = 4, 16, 64, 256. nan where no pixel is between.
double dispersion(std::span<const rt::Image> images, const Region& region, int samples);

/// Root of the mean variance of a region's pixels.
double noise_level(std::span<const rt::Image> images, const Region& region);

}  // namespace grade
