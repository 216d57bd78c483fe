#pragma once

#include "rt/scene.h"

namespace grade {

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

}  // namespace grade
