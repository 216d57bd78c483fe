#pragma once

#include "rt/files/image.h"
#include "statistics/region.h"

namespace grade {

/// Which part of the noise of one image pixels have in common: 0 for pixels with random numbers of their own, 1 where
/// the pixels of the whole image, of a row, or of a column share them.
///
/// The pixels must expect the same, and each sample must see 1 in one of the channels and 0 in the others, or 0 in all:
/// then N Var(pixel) = sum over the channels of p (1 - p), p the channel's mean. With V that variance, S the variance
/// within the image, B and W the mean squares between rows of n pixels and within them:
///
///     all = 1 - S/V,    rows = (B - W) / (B + (n - 1) W)
///
/// Pixels that are all equal share all; black ones say nothing, and count as independent.
///
/// Source: the intraclass correlation, Fisher, "Statistical Methods for Research Workers", 1925; the design effect of
/// samples that share r is 1 + (n - 1) r: Kish, "Survey Sampling", 1965.
struct Sharing {
    double all = 0, rows = 0, columns = 0;

    double sum() const { return all + rows + columns; }
};

Sharing sharing(const rt::Image& image, const Region& region, int samples);

/// Variance within one image over that of independent samples, S/V from above: 1; 0 where all pixels are equal.
double within_variance(const rt::Image& image, const Region& region, int samples);

}  // namespace grade
