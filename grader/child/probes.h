#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "child/rows.h"

/// A probe calls one fragment on one row of numbers; rows.h gives the numbers of each type.
///
///     fragment                in                                                        out
///     integrate_uniform       Integrand f, a, b, n                                      value, use of f
///     integrate_monte_carlo   Integrand f, Integrand density, list x                    value, use of f, of density
///     integrate_stratified    Integrand f, list of Stratum                              value, use of f
///     camera_ray              Camera, film (2)                                          Ray
///     hit_sphere              Sphere, Ray                                               distance
///     hit_triangle            Triangle, Ray                                             distance
///     hit_quad                Quad, Ray                                                 distance
///     point_irradiance        PointLight, p, n                                          Color
///     phong                   Material, ambient (3), irradiance (3), n, to_light,
///                             to_viewer                                                 Color
///     shadow_ray              Hit, to_light, distance                                   Ray
///     mirror_direction        d, n                                                      direction (3)
///     refracted_direction     d, n, ior_from, ior_to                                    direction (3)
///     fresnel_dielectric      cosine, ior_from, ior_to                                  reflectance
///     whitted                 Material, fresnel                                         Outgoing
///     stratified_2d           i, n, u (2)                                               point (2)
///     uniform_disk            u (2)                                                     DiskSample
///     cosine_hemisphere       u (2)                                                     DirectionSample
///     phong_lobe              exponent, u (2)                                           DirectionSample
///     sphere_cone             sine, u (2)                                               DirectionSample
///     film_sample             Extent, i, n, u (2)                                       FilmSample
///     pixel_mean              list of Color, list of weights                            Color
///     light_sample            Emitter, p, u (2)                                         LightSample
///     direct_light            Material, radiance (3), LightSample, n, to_viewer         Color
///     glossy_reflection       d, n, exponent, u (2)                                     Scattered
///     translucency            d, n, ior_from, ior_to, exponent, u (2)                   Scattered
///     lens_ray                Camera, pinhole Ray, u (2)                                Ray
///     shutter_time            Shutter, u                                                time
///     moved                   point, velocity, time                                     point (3)
///     color_bleeding          n, albedo, u (2)                                          Scattered
///     emission_counts         Event, sampled                                            0 or 1
///     free_flight             extinction, u                                             distance
///     scatter_direction       d, g, u (2)                                               DirectionSample
///
/// d, n, p and directions are 3 numbers. The use of an Integrand is three numbers: how often it was called, and the
/// least and greatest x (inf and -inf where it was not called).
///
/// A check builds a row with the arguments of the declaration, row(material, fresnel), and reads an output with
/// from_row<rt::Outgoing>(output).
namespace grade {

/// Calls a fragment. Throws std::invalid_argument for a name that is no fragment's, std::out_of_range for a row that is
/// too short, std::domain_error for one with numbers left over.
std::vector<double> probe(std::string_view fragment, std::span<const double> row);

}  // namespace grade
