#pragma once

namespace grade {

/// Closed forms of Phong's lobe of exponent n, of density (n + 1) / 2 pi cos^n a about its axis, a the angle from it.

/// Reflectance of the BRDF (n + 2) / 2 pi cos^n a, about the mirror direction of light at the given angle from the
/// normal, over k_s: the integral of BRDF x cosine over the directions above the surface. 1 at angle 0.
double phong_albedo(double exponent, double angle);

/// The same integral with a factor cos^k a: phong_moment(n, t, 0) - phong_moment(n, t, 1) tells the width of the lobe.
double phong_moment(double exponent, double angle, double k);

/// N Var / mean^2 of that reflectance at angle 0 under sampling of the lobe: 1 / ((n + 1) (n + 3)).
double lobe_dispersion(double exponent);

}  // namespace grade
