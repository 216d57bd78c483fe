#pragma once

#include <cmath>

#include "rt/scene.h"

/// Closed forms of what means and pictures must be.
namespace grade {

/// Radiance inside a closed box of which every wall emits `emission` and reflects `albedo` diffusely, after the given
/// number of bounces:
///
///     emission (1 - albedo^(bounces + 1)) / (1 - albedo)
inline double furnace_radiance(double emission, double albedo, int bounces) {
    return albedo == 1 ? emission * (bounces + 1) : emission * (1 - std::pow(albedo, bounces + 1)) / (1 - albedo);
}

/// Irradiance of a surface element by an emitter in plain sight, in units of the emitter's radiance [sr]: multiply by
/// the radiance.
///
/// p, n  the element's position and unit normal [world]

/// By a quad, seen from its front and wholly above the horizon:
///
///     1/2 |sum over edges of Theta_i Gamma_i . n|,  Theta_i the edge's angle, Gamma_i the unit normal of its plane
///     with p
///
/// Source: Lambert, "Photometria", 1760; Arvo, "The Irradiance Jacobian for Partially Occluded Polyhedral Sources",
/// 1994.
double quad_irradiance(const rt::Quad& quad, rt::vec3 p, rt::vec3 n);

/// By a disc of radius r that faces the element at height h above it: pi r^2 / (r^2 + h^2).
double coaxial_disc_irradiance(double radius, double height);

/// By a sphere wholly above the horizon: pi (r/d)^2 cos, the cosine at the element towards the centre.
double sphere_irradiance(const rt::Sphere& sphere, rt::vec3 p, rt::vec3 n);

/// Closed forms of Phong's lobe of exponent n, of density (n + 1) / 2 pi cos^n a about its axis, a the angle from it.

/// Reflectance of the BRDF (n + 2) / 2 pi cos^n a, about the mirror direction of light at the given angle from the
/// normal, over k_s: the integral of BRDF x cosine over the directions above the surface. 1 at angle 0.
double phong_albedo(double exponent, double angle);

/// The same integral with a factor cos^k a: phong_moment(n, t, 0) - phong_moment(n, t, 1) tells the width of the lobe.
double phong_moment(double exponent, double angle, double k);

/// N Var / mean^2 of that reflectance at angle 0 under sampling of the lobe: 1 / ((n + 1) (n + 3)).
double lobe_dispersion(double exponent);

/// What geometry makes of a feature, in the unit named.

/// Pixels that a length across the view takes at distance z along the axis.
inline double pixels_per_metre(const rt::Camera& camera, double z) {
    return camera.size.y / (2 * z * camera.tan_half_fov);
}

/// Radius of the disc to which a thin lens blurs a point at distance z along the axis [pixel]:
///
///     lens radius |z - focus| / focus, seen at distance z
inline double blur_radius(const rt::Camera& camera, double z) {
    return camera.lens_radius * std::abs(z - camera.focus) / camera.focus * pixels_per_metre(camera, z);
}

/// Width of the penumbra that an edge throws on a plane [m]:
///
///     width of the light * edge above plane / light above edge
inline double penumbra_width(double light_width, double light_height, double edge_height) {
    return light_width * edge_height / (light_height - edge_height);
}

/// How far a plane parallel slab moves a ray sideways, at right angles to it, in units of the slab's thickness:
///
///     sin t (1 - cos t / sqrt(n^2 - sin^2 t))
inline double slab_shift(double angle, double ior) {
    const double s = std::sin(angle);
    return s * (1 - std::cos(angle) / std::sqrt(ior * ior - s * s));
}

/// Variance along its way of a lamp's picture, when pixel, lens, time and the lamp's own disc do not depend on each
/// other: their variances add [pixel^2].
///
///     length^2 / 12 + blur^2 / 4 + lamp^2 / 4 + 1 / 12
///
/// length  of the way while the shutter is open; blur, lamp: radii of the lens's disc and of the lamp's [pixel]
inline double streak_variance(double length, double blur, double lamp) {
    return length * length / 12 + blur * blur / 4 + lamp * lamp / 4 + 1.0 / 12;
}

/// Mean number of scatterings of light that falls from all sides alike on a ball of medium, whatever the phase
/// function: the mean length of its ways is 4 V / S.
///
///     4/3 radius * scattering
///
/// Source: Blanco and Fournier, "An invariance property of diffusive random walks", Europhys. Lett. 61(2), 2003.
inline double mean_scatterings(double radius, double scattering) { return 4.0 / 3 * radius * scattering; }

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
