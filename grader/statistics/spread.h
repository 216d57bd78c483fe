#pragma once

#include <span>

#include "rt/files/image.h"
#include "statistics/region.h"

namespace grade {

/// Moments of a one-dimensional distribution, in pixels.
struct Spread {
    double mass = 0;
    double mean = 0;  // pixel k spans k to k + 1
    double variance = 0;
};

/// Moments of the line-spread function of an edge: of the derivative of its profile, rising or falling. The profile
/// must be flat at both ends. The pixels add 1/6 to the variance where the edge falls anywhere in a pixel: 1/12 by
/// their width, 1/12 by the differences.
Spread edge_spread(std::span<const double> profile);

/// A straight edge, x = offset + slope y in pixels.
struct Edge {
    double offset = 0, slope = 0;
};

/// Moments, about the edge, of the line-spread function along x of a slanted edge, bright on the right, between the
/// levels `left` and `right`. They are linear in the pixels, hence without bias from noise:
///
///     mean = sum over a row of (B(d) - F(d)),  mean square = 1/12 + sum over a row of 2 d (B(d) - F(d))
///
/// averaged over the rows, where d is the distance of a pixel's centre from the edge, F the level there, 0 to 1, and
/// B that of a box filter of one pixel, d + 1/2 between 0 and 1. The box filter itself gives mean 0 and mean square
/// (1 + slope^2) / 12; no filter gives 0 where the edge falls everywhere in a pixel, that is, slope * height is a whole
/// number.
struct SlantedSpread {
    double mean = 0, mean_square = 0;
};
SlantedSpread slanted_spread(const rt::Image& image, const Region& region, const Edge& edge, double left, double right);

/// The image with rows and columns exchanged, to measure along y what is measured along x.
rt::Image transposed(const rt::Image& image);

}  // namespace grade
