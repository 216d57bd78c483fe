#pragma once

#include <algorithm>

#include "rt/answers.h"
#include "rt/elementary.h"

/// The contents page of the assignment: one declaration for each fragment, in the order of the handout. Each is one
/// function in one file of fragments/, pure and for one ray; the docstring of its file says what it must do.
///
/// One declaration a line: the build reads this list.
namespace rt {

// clang-format off

// 1 integrals
Real integrate_uniform(const Function& f, Real a, Real b, int n);
Real integrate_monte_carlo(const Function& f, const Function& density, std::span<const Real> x);
Real integrate_stratified(const Function& f, std::span<const Stratum> strata);

// 2 Whitted
Ray camera_ray(const Camera& camera, vec2 film);
Real hit_sphere(const Sphere& sphere, const Ray& ray);
Real hit_triangle(const Triangle& triangle, const Ray& ray);
Real hit_quad(const Quad& quad, const Ray& ray);
Color point_irradiance(const PointLight& light, vec3 p, vec3 n);
Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer);
Ray shadow_ray(const Hit& hit, vec3 to_light, Real distance);
vec3 mirror_direction(vec3 d, vec3 n);
vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to);
Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to);
Outgoing whitted(const Material& material, Real fresnel);

// 3 sampling
vec2 stratified_2d(int i, int n, vec2 u);
DiskSample uniform_disk(vec2 u);
DirectionSample cosine_hemisphere(vec2 u);
DirectionSample phong_lobe(Real exponent, vec2 u);
DirectionSample sphere_cone(Real sine, vec2 u);

// 4 distribution
FilmSample film_sample(const Extent& pixel, int i, int n, vec2 u);
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight);
LightSample light_sample(const Emitter& light, vec3 p, vec2 u);
Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer);
Scattered glossy_reflection(vec3 d, vec3 n, Real exponent, vec2 u);
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u);
Ray lens_ray(const Camera& camera, const Ray& pinhole, vec2 u);
Real shutter_time(const Shutter& shutter, Real u);
vec3 moved(vec3 point, vec3 velocity, Real time);
Scattered color_bleeding(vec3 n, Color albedo, vec2 u);
bool emission_counts(Event previous, bool sampled);
Real free_flight(Real extinction, Real u);
DirectionSample scatter_direction(vec3 d, Real g, vec2 u);

// clang-format on

/// Reports once, with file and line, that the fragment which calls it is a blank.
void report_not_started(const char* file, int line);

/// The value that a blank returns: harmless, and documented in the fragment's file. file and line are the caller's;
/// std::source_location is missing from Clang 14.
template <class Value>
Value not_started(Value neutral, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    report_not_started(file, line);
    return neutral;
}

}  // namespace rt
