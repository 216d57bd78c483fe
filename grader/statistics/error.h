#pragma once

#include "rt/files/image.h"

/// Errors of pictures, where the truth itself is known from noisy pictures only: two that do not depend on each other.
namespace grade {

/// Two independent pictures of the truth, each without bias.
struct Halves {
    rt::Image first, second;
};

/// Mean over pixels and channels, without bias, whatever the noise of the halves:
///
///     mse       <(A - R1)(A - R2)>
///     relative  <(A - R1)(A - R2) / (R^2 + 0.01)>,  R the mean of the halves
///
/// Both may come out below 0 where the halves are noisier than A.
struct SquaredError {
    double mse = 0, relative = 0;
};

/// All pictures have one size.
SquaredError squared_error(const rt::Image& a, const Halves& halves);

/// A number with its standard error.
struct Estimate {
    double value = 0, se = 0;

    /// Whether it is above 0 by more than chance: by 4 standard errors, one case in 30,000.
    bool is_positive() const { return value > 4 * se && value > 0; }
};

/// The square of a bias, mean over pixels and channels, from two independent estimates of one picture:
///
///     <(A1 - R1)(A2 - R2) + (A1 - R2)(A2 - R1)> / 2
///
/// Where there is no bias, each pixel's product has the mean 0, whatever the noise. The standard error is that of the
/// noise alone, of which each pixel must have its own: with V the variance of A1 - R1, known from A1 - A2 and R1 - R2,
/// that of a product is V^2 + 2 V b^2. Noise with long tails makes it too large, never too small; so does noise that
/// channels do not share.
Estimate picture_bias(const rt::Image& a1, const rt::Image& a2, const Halves& halves);

/// Root mean square error of the mean of the two halves, from their difference.
double noise_of(const Halves& halves);

}  // namespace grade
