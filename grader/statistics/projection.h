#pragma once

#include <cmath>

#include "rt/scene.h"

namespace grade {

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

}  // namespace grade
