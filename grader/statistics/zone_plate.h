#pragma once

#include "rt/scene.h"

namespace grade {

/// Rings that grow finer outwards, between 0 and 1. At distance r from the centre there are rate r / pi rings a pixel.
///
///     (1 + cos(rate |p|^2)) / 2
///
/// p  film point from the rings' centre [pixel]
double zone_plate(double rate, rt::vec2 p);

/// Its mean over a rectangle, what a box filter makes of it: the real part of a product of two integrals of exp(i rate
/// x^2), one an axis, by Gauss and Legendre's rule; exact to 1e-9 up to 4 rings a pixel.
double zone_plate_mean(double rate, const rt::Extent& pixel);

/// The square of an estimate's bias, free of its noise, from the errors of two estimates of one mean: their product.
inline double squared_bias(double first, double second, double due) { return (first - due) * (second - due); }

}  // namespace grade
